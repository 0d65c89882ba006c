#include "figure_sheet.h"

#include "drawing.h"
#include "memory.h"

#include <pcl/core/cloud_fields.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>

namespace pcl::acmap {

namespace {

constexpr int gap = 6; // px between two pictures

double
aspectOf(const RgbImage& image)
{
  return static_cast<double>(image.width) / image.height;
}

/** \brief Widths of the pictures of a row, so that they fill it together with the
 * gaps. */
std::vector<int>
widthsOf(const std::vector<RgbImage>& row, int width)
{
  double sum = 0;
  for (const RgbImage& image : row)
    sum += aspectOf(image);
  const int all = width - gap * (static_cast<int>(row.size()) - 1);
  std::vector<int> widths;
  for (const RgbImage& image : row)
    widths.push_back(static_cast<int>(std::lround(all * aspectOf(image) / sum)));
  widths.back() += all - std::accumulate(widths.begin(), widths.end(), 0);
  return widths;
}

int
heightOf(const std::vector<RgbImage>& row, const std::vector<int>& widths)
{
  return std::max(1, static_cast<int>(std::lround(widths[0] / aspectOf(row[0]))));
}

/** \brief Resamples along one direction.
 * \param[in] step from one value to the next, in bytes */
void
shrinkLine(const double* from, int length, int step, double* to, int new_length)
{
  const double ratio = static_cast<double>(length) / new_length;
  for (int i = 0; i < new_length; ++i) {
    const double begin = i * ratio, end = (i + 1) * ratio;
    double sum = 0;
    for (int k = static_cast<int>(begin);
         k < std::min(length, static_cast<int>(std::ceil(end)));
         ++k)
      sum += from[k * step] * (std::min(end, k + 1.0) - std::max(begin, double(k)));
    to[i * step] = sum / ratio;
  }
}

} // namespace

RgbImage
rgbOf(const CameraImage& image)
{
  RgbImage colored{image.width, image.height, {}};
  if (image.channels == 3) {
    colored.values = image.values;
    return colored;
  }
  for (const std::uint8_t grey : image.values)
    colored.values.insert(colored.values.end(), 3, grey);
  return colored;
}

RgbImage
resized(const RgbImage& image, int width, int height)
{
  if (image.width == width && image.height == height)
    return image;
  std::vector<double> from(image.values.begin(), image.values.end());
  std::vector<double> rows(static_cast<std::size_t>(3 * width * image.height));
  for (int y = 0; y < image.height; ++y)
    for (int c = 0; c < 3; ++c)
      shrinkLine(&from[static_cast<std::size_t>(3 * y * image.width + c)],
                 image.width,
                 3,
                 &rows[static_cast<std::size_t>(3 * y * width + c)],
                 width);
  std::vector<double> all(static_cast<std::size_t>(3 * width * height));
  for (int x = 0; x < 3 * width; ++x)
    shrinkLine(&rows[static_cast<std::size_t>(x)],
               image.height,
               3 * width,
               &all[static_cast<std::size_t>(x)],
               height);
  RgbImage smaller{width, height, {}};
  for (const double value : all)
    smaller.values.push_back(static_cast<std::uint8_t>(std::lround(value)));
  return smaller;
}

RgbImage
sheetOf(const std::vector<std::vector<RgbImage>>& rows, int width)
{
  int height = -gap;
  for (const auto& row : rows)
    height += heightOf(row, widthsOf(row, width)) + gap;
  RgbImage sheet = whiteImage(width, height);
  int top = 0;
  for (const auto& row : rows) {
    const std::vector<int> widths = widthsOf(row, width);
    const int row_height = heightOf(row, widths);
    int left = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      paste(resized(row[i], widths[i], row_height), left, top, sheet);
      left += widths[i] + gap;
    }
    top += row_height + gap;
  }
  return sheet;
}

RgbImage
withFewLevels(RgbImage image, int step)
{
  constexpr int brightest = 255;
  for (std::uint8_t& value : image.values)
    value = static_cast<std::uint8_t>(
        std::min((value + step / 2) / step * step, brightest));
  return image;
}

std::uint8_t
lightened(std::uint8_t level)
{
  constexpr double gain = 2.5, brightest = 255;
  return static_cast<std::uint8_t>(std::lround(std::min(gain * level, brightest)));
}

RgbImage
lightened(RgbImage image)
{
  for (std::uint8_t& value : image.values)
    value = lightened(value);
  return image;
}

void
lighten(PCLPointCloud2& cloud)
{
  const PCLPointField* const color = findColor(cloud);
  if (!color)
    return;
  for (std::size_t i = 0; i < rowsOf(cloud); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint8_t& level = cloud.data[i * cloud.point_step + color->offset + c];
      level = lightened(level);
    }
}

RgbImage
coloredDisparity(const DisparityImage& image, float least, float most)
{
  static const std::array<std::array<float, 3>, 6> colors = {{{50, 20, 110},
                                                              {40, 110, 230},
                                                              {30, 190, 190},
                                                              {130, 220, 60},
                                                              {250, 170, 40},
                                                              {160, 20, 10}}};
  RgbImage colored{image.width, image.height, {}};
  colored.values.assign(3 * image.values.size(), 0);
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    if (!std::isfinite(image.values[i]))
      continue;
    const float share =
        std::clamp((image.values[i] - least) / (most - least), 0.0f, 1.0f);
    const float place = share * static_cast<float>(colors.size() - 1);
    const std::size_t below =
        std::min(static_cast<std::size_t>(place), colors.size() - 2);
    const float t = place - static_cast<float>(below);
    for (std::size_t c = 0; c < 3; ++c)
      colored.values[3 * i + c] = static_cast<std::uint8_t>(
          std::lround((1 - t) * colors[below][c] + t * colors[below + 1][c]));
  }
  return colored;
}

RgbImage
drawn(const OutputFolder& folder,
      const std::function<void(const std::string& path)>& draw)
{
  const std::string path = folder.path("drawing.png");
  {
    const UnlimitedMemory while_drawing;
    draw(path);
  }
  RgbImage image = loadRgbImage(path);
  std::filesystem::remove(path);
  return image;
}

} // namespace pcl::acmap
