#include "depth_room.h"

#include <pcl/core/random.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Eigen::Vector3d
rayOf(std::size_t pixel)
{
  return {(static_cast<double>(pixel % DepthRoom::width) - DepthRoom::width / 2.0) /
              DepthRoom::focal,
          (static_cast<double>(pixel / DepthRoom::width) - DepthRoom::height / 2.0) /
              DepthRoom::focal,
          1};
}

/** White noise plus noise that is smoothed over 7 x 7 pixels, with its deviation
 * preserved. */
std::vector<double>
noiseOf(const DepthRoom::Camera& camera)
{
  constexpr std::int64_t reach = 3;
  constexpr auto width = static_cast<std::int64_t>(DepthRoom::width);
  constexpr auto height = static_cast<std::int64_t>(DepthRoom::height);
  Random random(camera.seed);
  std::vector<double> white(DepthRoom::width * DepthRoom::height);
  for (double& value : white)
    value = random.normal();
  std::vector<double> noise(white.size());
  for (std::int64_t row = 0; row < height; ++row)
    for (std::int64_t column = 0; column < width; ++column) {
      double sum = 0, count = 0;
      for (std::int64_t y = std::max<std::int64_t>(row - reach, 0);
           y <= std::min(row + reach, height - 1);
           ++y)
        for (std::int64_t x = std::max<std::int64_t>(column - reach, 0);
             x <= std::min(column + reach, width - 1);
             ++x, ++count)
          sum += white[static_cast<std::size_t>(y * width + x)];
      noise[static_cast<std::size_t>(row * width + column)] =
          camera.correlated * sum / std::sqrt(count) +
          camera.independent * random.normal();
    }
  return noise;
}

std::vector<Eigen::Vector3f>
measured(const std::vector<double>& depths, const DepthRoom::Camera& camera)
{
  const std::vector<double> noise = noiseOf(camera);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    double inverse_depth = 1 / depths[i] + noise[i];
    if (camera.step > 0)
      inverse_depth = std::round(inverse_depth / camera.step) * camera.step;
    points.push_back(
        std::isfinite(depths[i])
            ? Eigen::Vector3f((rayOf(i) / inverse_depth).cast<float>())
            : Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  }
  return points;
}

} // namespace

DepthRoom::DepthRoom(const Camera& camera)
{
  const double tilt = 0.1;
  planes = {{{std::sin(tilt), 0, std::cos(tilt)}, 4.0},
            {{1, 0, 0}, 1.5},
            {{0, 1, 0}, 1.2},
            {{0, 0, 1}, 2.0},
            {{0, 1, 0}, 0.7}};
  truth.assign(width * height, -1);
  true_depths.assign(width * height, infinity);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Eigen::Vector3d ray = rayOf(i);
    for (std::size_t p = 0; p < planes.size(); ++p) {
      const double depth = planes[p].distance / planes[p].normal.dot(ray);
      if (!(depth > 0) || depth >= true_depths[i])
        continue;
      const Eigen::Vector3d place = depth * ray;
      const bool is_of_box = p >= 3;
      const bool is_on_box = place.x() > -0.9 && place.x() < -0.1 &&
                             place.y() >= 0.7 - 1e-9 && place.z() >= 2.0 - 1e-9 &&
                             place.z() < 3.0;
      if (is_of_box && !is_on_box)
        continue;
      true_depths[i] = depth;
      truth[i] = static_cast<std::int32_t>(p);
    }
  }
  points = measured(true_depths, camera);
}

std::vector<Eigen::Vector3f>
depthOfCylinder(const DepthRoom::Camera& camera, double radius, double distance)
{
  std::vector<double> depths(DepthRoom::width * DepthRoom::height, infinity);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    // solves |z (x, 1) - (0, distance)| = radius in the x-z plane
    const double x = rayOf(i).x();
    const double a = x * x + 1;
    const double root =
        distance * distance - a * (distance * distance - radius * radius);
    if (root > 0)
      depths[i] = (distance - std::sqrt(root)) / a;
  }
  return measured(depths, camera);
}

} // namespace pcl::acmap::test
