#include "shot_picture.h"

#include <pcl/core/image_file.h>

#include <array>

namespace pcl::acmap::bench {

namespace {

constexpr int gap = 4; // px between two pictures
constexpr std::uint8_t paper = 255;

/** \brief Rows of pictures of one size, each made smaller; in 64 levels a colour, for a
 * small file. */
class Sheet {
public:
  Sheet(int columns, int rows, int width, int height, int smaller)
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
  put(int column, int row, const CameraImage& image)
  {
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x)
        for (int channel = 0; channel < 3; ++channel)
          sheet_.at(column * (width_ + gap) + x, row * (height_ + gap) + y)[channel] =
              meanOf(image, x, y, channel);
  }

  void
  save(const std::string& path) const
  {
    savePng(path, sheet_);
  }

private:
  std::uint8_t
  meanOf(const CameraImage& image, int x, int y, int channel) const
  {
    constexpr int levels = 63;
    constexpr int brightest = 255;
    int sum = 0;
    for (int dy = 0; dy < smaller_; ++dy)
      for (int dx = 0; dx < smaller_; ++dx)
        sum += image.values[static_cast<std::size_t>(
            3 * ((smaller_ * y + dy) * image.width + smaller_ * x + dx) + channel)];
    const int most = brightest * smaller_ * smaller_;
    const int level = (sum * levels + most / 2) / most;
    return static_cast<std::uint8_t>(level * brightest / levels);
  }

  int smaller_;
  int width_;
  int height_;
  RgbImage sheet_;
};

} // namespace

void
saveShotPicture(const std::string& path, const RigSimulation& simulation)
{
  constexpr std::uint64_t seed = 1;
  constexpr std::size_t place = 8;
  constexpr std::array<std::size_t, 2> other_places = {21, 60};
  constexpr std::size_t off = 0, first_pattern = 1;
  constexpr int columns = 4, smaller = 3;
  const auto reference =
      [&](const LitViews& views, std::size_t view, std::size_t shot) {
        return simulation.shoot(views, view, shot, seed)->image(RigCamera::Reference);
      };
  const LitViews here = simulation.cast(place);
  Sheet sheet(columns, 2, here[0].width, here[0].height, smaller);
  for (int column = 0; column < columns; ++column)
    sheet.put(column, 0, reference(here, place, static_cast<std::size_t>(column)));
  const auto lit = simulation.shoot(here, place, first_pattern, seed);
  sheet.put(0, 1, lit->image(RigCamera::Horizontal));
  sheet.put(1, 1, lit->image(RigCamera::Vertical));
  for (std::size_t i = 0; i < other_places.size(); ++i)
    sheet.put(2 + static_cast<int>(i),
              1,
              reference(simulation.cast(other_places[i]), other_places[i], off));
  sheet.save(path);
}

void
savePatternPicture(const std::string& path, const RgbImage& pattern)
{
  Sheet sheet(1, 1, pattern.width, pattern.height, 2);
  sheet.put(0, 0, {pattern.width, pattern.height, 3, pattern.values});
  sheet.save(path);
}

} // namespace pcl::acmap::bench
