#include "painted_views.h"

#include <pcl/core/random.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {

namespace {

constexpr int width = 240, height = 180;
const Eigen::Vector2d middle(119.5, 89.5);

} // namespace

Wallpaper::Wallpaper(std::uint64_t seed, double contrast)
: waves_(80)
, amplitude_(contrast * std::sqrt(2.0 / 80))
{
  constexpr double turn = 6.283185307179586;
  Random random(seed);
  for (Wave& wave : waves_) {
    const double frequency = turn / random.uniform(8, 60),
                 angle = random.uniform(0, turn);
    wave.frequency = frequency * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    wave.phase = random.uniform(0, turn);
  }
}

double
Wallpaper::at(const Eigen::Vector2d& place) const
{
  double sum = 0;
  for (const Wave& wave : waves_)
    sum += std::cos(wave.frequency.dot(place) + wave.phase);
  return 128 + amplitude_ * sum;
}

Eigen::Vector2d
ViewChange::operator()(const Eigen::Vector2d& pixel) const
{
  return scale * (Eigen::Rotation2Dd(turn) * (pixel - middle)) + middle + shift;
}

Eigen::Vector2d
ViewChange::inverse(const Eigen::Vector2d& pixel) const
{
  return Eigen::Rotation2Dd(-turn) * (pixel - middle - shift) / scale + middle;
}

GreyImage
paint(const Wallpaper& paper, const ViewChange& change)
{
  GreyImage image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.values.push_back(
          static_cast<float>(paper.at(change.inverse(Eigen::Vector2d(x, y)))));
  return image;
}

std::vector<std::int32_t>
keypointsOf(const GreyImage& image, std::size_t maximum)
{
  KeypointSettings settings;
  settings.maximum = maximum;
  KeypointCounts counts;
  return gradientMaxima(
      image, std::vector<std::uint8_t>(image.values.size(), 1), settings, counts);
}

Eigen::Vector2d
placeOf(std::int32_t pixel, const GreyImage& image)
{
  return {pixel % image.width, pixel / image.width};
}

PointCloud<PointXYZRGB>::Ptr
wallOf(const GreyImage& image)
{
  PointCloud<PointXYZRGB>::Ptr cloud(
      new PointCloud<PointXYZRGB>(static_cast<std::uint32_t>(image.width),
                                  static_cast<std::uint32_t>(image.height)));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y * image.width + x);
      PointXYZRGB& point = (*cloud)[pixel];
      const Eigen::Vector3d ray((x - middle.x()) / 200, (y - middle.y()) / 200, 1);
      const double depth = 2 / (1 - 0.3 * ray.x());
      point.getVector3fMap() = (depth * ray).cast<float>();
      const double value = std::clamp<double>(image.values[pixel], 0, 255);
      point.r = point.g = point.b = static_cast<std::uint8_t>(std::lround(value));
    }
  return cloud;
}

} // namespace pcl::acmap::test
