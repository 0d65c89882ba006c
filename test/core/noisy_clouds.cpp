#include "noisy_clouds.h"

#include <cmath>

namespace pcl::acmap::test {

void
NoisyCloud::addPatch(const Patch& patch,
                     double density,
                     double sigma,
                     Random& random,
                     std::int32_t seen_from)
{
  const auto size =
      static_cast<std::size_t>(std::lround(patch.u.cross(patch.v).norm() * density));
  const Eigen::Vector3d normal = patch.normal();
  for (std::size_t i = 0; i < size; ++i) {
    const double along_u = random.uniform();
    const double along_v = random.uniform();
    const Eigen::Vector3d place = patch.corner + along_u * patch.u + along_v * patch.v +
                                  sigma * random.normal() * normal;
    points.emplace_back(place.cast<float>());
    view.push_back(seen_from);
  }
}

Patch
squarePatch(double side, double inclination)
{
  const Eigen::AngleAxisd tilt(inclination, Eigen::Vector3d(1, 2, 0).normalized());
  const Eigen::Vector3d u = tilt * Eigen::Vector3d(side, 0, 0);
  const Eigen::Vector3d v = tilt * Eigen::Vector3d(0, side, 0);
  return {Eigen::Vector3d(0.3, -0.2, 2) - (u + v) / 2, u, v};
}

NoisyCloud
makeNoisyRoom(double density, double sigma, std::uint64_t seed)
{
  const Eigen::Vector3d half(6, 6, 1.5);
  NoisyCloud cloud;
  cloud.viewpoints = {Eigen::Vector3f::Zero()};
  Random random(seed);
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const int next = (axis + 1) % 3;
      const int last = (axis + 2) % 3;
      const Eigen::Vector3d u = -2 * side * half[next] * Eigen::Vector3d::Unit(next);
      const Eigen::Vector3d v = 2 * half[last] * Eigen::Vector3d::Unit(last);
      const Eigen::Vector3d middle = side * half[axis] * Eigen::Vector3d::Unit(axis);
      cloud.addPatch({middle - (u + v) / 2, u, v}, density, sigma, random);
    }
  return cloud;
}

NoisyCloud
shuffled(const NoisyCloud& cloud, std::uint64_t seed)
{
  NoisyCloud result = cloud;
  Random random(seed);
  for (std::size_t i = cloud.points.size(); i > 1; --i) {
    const std::size_t other = random.bits() % i;
    std::swap(result.points[i - 1], result.points[other]);
    std::swap(result.view[i - 1], result.view[other]);
  }
  return result;
}

} // namespace pcl::acmap::test
