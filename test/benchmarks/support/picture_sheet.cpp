#include "picture_sheet.h"

#include <algorithm>

namespace pcl::acmap::bench {

namespace {

constexpr int gap = 4; // px between two pictures
constexpr std::uint8_t paper = 255;

} // namespace

PictureSheet::PictureSheet(int columns, int rows, int width, int height, int smaller)
: smaller_(smaller)
, width_(width / smaller)
, height_(height / smaller)
{
  sheet_.width = columns * (width_ + gap) - gap;
  sheet_.height = rows * (height_ + gap) - gap;
  sheet_.values.assign(static_cast<std::size_t>(3 * sheet_.width * sheet_.height),
                       paper);
}

void
PictureSheet::put(int column, int row, const CameraImage& image)
{
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x)
      for (int channel = 0; channel < 3; ++channel)
        sheet_.at(column * (width_ + gap) + x, row * (height_ + gap) + y)[channel] =
            meanOf(image, x, y, std::min(channel, image.channels - 1));
}

void
PictureSheet::save(const std::string& path) const
{
  savePng(path, sheet_);
}

std::uint8_t
PictureSheet::meanOf(const CameraImage& image, int x, int y, int channel) const
{
  constexpr int levels = 63;
  constexpr int brightest = 255;
  int sum = 0;
  for (int dy = 0; dy < smaller_; ++dy)
    for (int dx = 0; dx < smaller_; ++dx)
      sum += image.values[static_cast<std::size_t>(
          image.channels * ((smaller_ * y + dy) * image.width + smaller_ * x + dx) +
          channel)];
  const int maximum = brightest * smaller_ * smaller_;
  const int level = (sum * levels + maximum / 2) / maximum;
  return static_cast<std::uint8_t>(level * brightest / levels);
}

} // namespace pcl::acmap::bench
