#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <cstring>

namespace pcl::acmap {

/** \brief A hash of coordinates, bit by bit. */
inline std::uint64_t
hashOfPlace(const Eigen::Vector3f& point, std::uint64_t seed = 0)
{
  std::uint64_t hash = seed;
  for (int axis = 0; axis < 3; ++axis) {
    std::uint32_t bits;
    std::memcpy(&bits, &point[axis], sizeof bits);
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return hash;
}

/** \brief Selects about \a wanted of \a size points by a hash of their coordinates, so
 * that the result does not depend on their order; equal points are selected together.
 */
class PointSample {
public:
  PointSample(std::size_t size, std::size_t wanted)
  : share_(size <= wanted ? 1.0
                          : static_cast<double>(wanted) / static_cast<double>(size))
  {}

  bool
  holds(const Eigen::Vector3f& point) const
  {
    if (share_ == 1.0)
      return true;
    const std::uint64_t hash = hashOfPlace(point);
    return static_cast<double>(hash >> 11) * 0x1.0p-53 < share_;
  }

private:
  double share_;
};

} // namespace pcl::acmap
