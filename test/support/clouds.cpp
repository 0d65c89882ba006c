#include "clouds.h"

#include <pcl/core/random.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace pcl::acmap::test {
namespace {

PointXYZ
onExactPlane(float x, float y, ExactPlane plane)
{
  return {x, y, plane == ExactPlane::Level ? 0.0F : x};
}

/** The numbers 0 .. size - 1 in random order. */
std::vector<std::size_t>
shuffledNumbers(std::size_t size, std::uint64_t seed)
{
  Random random(seed);
  std::vector<std::size_t> numbers(size);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  for (std::size_t i = size; i > 1; --i)
    std::swap(numbers[i - 1], numbers[random.bits() % i]);
  return numbers;
}

} // namespace

PointXYZ
toPoint(const Eigen::Vector3d& p)
{
  return {
      static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

Cloud
makeGrid(int columns, int rows, double spacing, ExactPlane plane)
{
  Cloud cloud;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      cloud.push_back(onExactPlane(static_cast<float>(column * spacing),
                                   static_cast<float>(row * spacing),
                                   plane));
  return cloud;
}

Cloud
makeHexagonalGrid(int columns, int rows, double spacing)
{
  Cloud cloud;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      cloud.push_back(toPoint(
          {(column + (row % 2) / 2.0) * spacing, row * std::sqrt(0.75) * spacing, 0}));
  return cloud;
}

Cloud
makeRandomPlane(std::size_t size, ExactPlane plane, std::uint64_t seed)
{
  Random random(seed);
  Cloud cloud;
  for (std::size_t i = 0; i < size; ++i) {
    const auto x = static_cast<float>(random.uniform());
    cloud.push_back(onExactPlane(x, static_cast<float>(random.uniform()), plane));
  }
  return cloud;
}

Cloud
makeExactCircle(int radius, bool with_center)
{
  Cloud cloud;
  for (int x = -radius; x <= radius; ++x)
    for (int y = -radius; y <= radius; ++y)
      if (x * x + y * y == radius * radius || (with_center && x == 0 && y == 0))
        cloud.push_back({static_cast<float>(x), static_cast<float>(y), 0});
  return cloud;
}

Cloud
makeRandomBox(std::size_t size, std::uint64_t seed)
{
  Random random(seed);
  Cloud cloud;
  for (std::size_t i = 0; i < size; ++i) {
    const double x = random.uniform();
    const double y = random.uniform();
    cloud.push_back(toPoint({x, y, random.uniform()}));
  }
  return cloud;
}

Cloud
makeLattice(int side)
{
  Cloud cloud;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z)
        cloud.push_back(
            {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  return cloud;
}

Cloud
makeMoebiusBand(int around, int across, double radius, double width, std::uint64_t seed)
{
  Random random(seed);
  Cloud cloud;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double angle = 2 * M_PI * (i + random.uniform(-0.2, 0.2)) / around;
      const double offset =
          width * ((j + random.uniform(-0.2, 0.2)) / (across - 1) - 0.5);
      const double distance = radius + offset * std::cos(angle / 2);
      cloud.push_back(toPoint({distance * std::cos(angle),
                               distance * std::sin(angle),
                               offset * std::sin(angle / 2)}));
    }
  return cloud;
}

Cloud
makeCoincident(std::size_t size)
{
  Cloud cloud;
  cloud.resize(size, PointXYZ(1, 2, 3));
  return cloud;
}

Cloud
makeCollinear(std::size_t size)
{
  Cloud cloud;
  for (std::size_t i = 0; i < size; ++i) {
    const auto step = static_cast<float>(i);
    cloud.push_back({step, 2 * step, -3 * step});
  }
  return cloud;
}

Cloud
doubled(const Cloud& cloud)
{
  Cloud twice = cloud;
  return twice += cloud;
}

Cloud
lacedWithNan(const Cloud& cloud, std::size_t period)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Cloud laced;
  laced.is_dense = false;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (i % period == 0)
      laced.push_back(i % (2 * period) == 0 ? PointXYZ(nan, nan, nan)
                                            : PointXYZ(cloud[i].x, infinity, 0));
    laced.push_back(cloud[i]);
  }
  return laced;
}

Cloud
withOutlier(Cloud cloud, float coordinate)
{
  cloud.push_back({coordinate, coordinate, coordinate});
  return cloud;
}

Cloud
permuted(const Cloud& cloud, std::uint64_t seed)
{
  Cloud result;
  for (const std::size_t i : shuffledNumbers(cloud.size(), seed))
    result.push_back(cloud[i]);
  return result;
}

Cloud
moved(const Cloud& cloud, const Eigen::Isometry3d& motion)
{
  Cloud result;
  for (const PointXYZ& point : cloud)
    result.push_back(toPoint(motion * point.getVector3fMap().cast<double>()));
  return result;
}

Cloud
scaled(const Cloud& cloud, float factor)
{
  Cloud result;
  for (const PointXYZ& point : cloud)
    result.push_back({point.x * factor, point.y * factor, point.z * factor});
  return result;
}

Eigen::Isometry3d
makeRandomMotion(std::uint64_t seed, double distance)
{
  Random random(seed);
  Eigen::Vector4d rotation;
  for (double& value : rotation)
    value = random.normal();
  Eigen::Isometry3d motion(Eigen::Quaterniond(rotation.normalized()));
  for (double& value : motion.translation().reshaped())
    value = random.uniform(-distance, distance);
  return motion;
}

Cloud
makeCorridorView(std::size_t size, std::uint64_t seed)
{
  constexpr int columns = 640;
  constexpr int rows = 480;
  constexpr double focal_length = 520;
  constexpr double end = 12;
  Random random(seed);
  std::vector<std::optional<PointXYZ>> hits(columns * rows);
  for (const std::size_t pixel : shuffledNumbers(hits.size(), seed)) {
    if (size == 0)
      break;
    const Eigen::Vector3d ray(
        (static_cast<double>(pixel % columns) - 319.5) / focal_length,
        (static_cast<double>(pixel / columns) - 239.5) / focal_length,
        1);
    const double side = 1.2 / std::max(std::abs(ray.x()), 1e-9);
    const double level = (ray.y() > 0 ? 1.1 : 1.6) / std::max(std::abs(ray.y()), 1e-9);
    const double z = std::min({side, level, end});
    const double noise = std::clamp(0.0025 * z * z, 0.01, 0.03) * random.normal();
    hits[pixel] = toPoint(ray * z + ray.normalized() * noise);
    --size;
  }
  Cloud cloud;
  for (const auto& hit : hits)
    if (hit)
      cloud.push_back(*hit);
  return cloud;
}

} // namespace pcl::acmap::test
