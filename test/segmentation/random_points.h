#pragma once

#include <pcl/core/random.h>
#include <pcl/core/scratch_memory.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>

namespace pcl::acmap::test {

/** \brief Points in a cube.
 * \param[in] extent half of its edge, metres */
inline LargeVector<Eigen::Vector3d>
makePoints(std::size_t size,
           double extent,
           const Eigen::Vector3d& middle,
           std::uint64_t seed)
{
  Random random(seed);
  LargeVector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < size; ++i) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    points.push_back(middle + extent * Eigen::Vector3d(x, y, random.uniform(-1, 1)));
  }
  return points;
}

} // namespace pcl::acmap::test
