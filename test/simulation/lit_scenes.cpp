#include "lit_scenes.h"

#include <cmath>

namespace pcl::acmap::test {

SimulatedLight
plainLight()
{
  SimulatedLight light;
  light.projector.width = 256;
  light.projector.height = 192;
  light.projector.focal_length = 233.0;
  light.projector.center_x = 127.5;
  light.projector.center_y = 95.5;
  light.projector.aperture_radius = 160.0;
  light.projector.power = 1.0;
  light.projector.blur = 0.0;
  light.ambient = 0.5;
  light.read_noise = 0.0;
  light.shot_noise = 0.0;
  light.blur = 0.0;
  return light;
}

RgbImage
flatPattern(const SimulatedProjector& projector, std::uint8_t value)
{
  RgbImage image;
  image.width = projector.width;
  image.height = projector.height;
  image.values.assign(static_cast<std::size_t>(3 * image.width * image.height), value);
  return image;
}

RgbImage
wavePattern(const SimulatedProjector& projector)
{
  RgbImage image = flatPattern(projector, 0);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      for (int channel = 0; channel < 3; ++channel)
        image.at(column, row)[channel] = static_cast<std::uint8_t>(
            std::lround(127.0 + 60.0 * std::sin(0.21 * column + channel) +
                        60.0 * std::cos(0.17 * row - channel)));
  return image;
}

int
valueAt(const CameraImage& image, int column, int row, int channel)
{
  return image.values[static_cast<std::size_t>(
      image.channels * (row * image.width + column) + channel)];
}

} // namespace pcl::acmap::test
