#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>

#include <array>
#include <cstdint>

namespace pcl::acmap {

/** \brief A voxel and an octant of directions in 63 bits: 20 bits each for x, y, z, and
 * 3 for the octant. z is the fastest axis in ascending order of keys. */
using VoxelKey = std::uint64_t;

inline constexpr int voxel_axis_bits = 20;
inline constexpr int octant_bits = 3;

/** \brief Indices of a voxel, counted from the minimum corner of the lattice. */
using VoxelPlace = std::array<std::int32_t, 3>;

inline VoxelKey
voxelKey(const VoxelPlace& place, unsigned octant = 0)
{
  return (static_cast<VoxelKey>(place[0]) << (2 * voxel_axis_bits + octant_bits)) |
         (static_cast<VoxelKey>(place[1]) << (voxel_axis_bits + octant_bits)) |
         (static_cast<VoxelKey>(place[2]) << octant_bits) | octant;
}

inline VoxelPlace
placeOf(VoxelKey key)
{
  constexpr VoxelKey mask = (VoxelKey{1} << voxel_axis_bits) - 1;
  return {
      static_cast<std::int32_t>((key >> (2 * voxel_axis_bits + octant_bits)) & mask),
      static_cast<std::int32_t>((key >> (voxel_axis_bits + octant_bits)) & mask),
      static_cast<std::int32_t>((key >> octant_bits) & mask)};
}

inline unsigned
octantOf(VoxelKey key)
{
  return static_cast<unsigned>(key & ((1u << octant_bits) - 1));
}

/** \brief The key without its octant, which is equal for all cells of a voxel. */
inline VoxelKey
voxelOf(VoxelKey key)
{
  return key >> octant_bits << octant_bits;
}

/** \brief Octant of a direction: one bit per axis, set if its component is positive. */
inline unsigned
octantAlong(float x, float y, float z)
{
  return (x > 0 ? 4u : 0u) | (y > 0 ? 2u : 0u) | (z > 0 ? 1u : 0u);
}

/** \brief Octant of the direction from a point to its sensor: one bit per axis, set if
 * the coordinate of the sensor is larger. */
inline unsigned
octantTowards(const Eigen::Vector3f& point, const Eigen::Vector3f& sensor)
{
  const Eigen::Vector3f way = sensor - point;
  return octantAlong(way.x(), way.y(), way.z());
}

/** \brief The voxel of a point, and the offset of the point from the centre of the
 * voxel in units of 2^-14 of its edge. */
struct VoxelHit {
  VoxelPlace place;
  std::array<std::int32_t, 3> offset;
};

/** \brief Voxels whose corners are the multiples of their edge, so that clouds in the
 * same frame share them. It extends over 2^20 voxels along each axis, centred at the
 * cloud for which it was created. \ingroup core */
class ACMAP_EXPORT VoxelLattice {
public:
  static constexpr int offset_bits = 14;

  VoxelLattice() = default;

  /** \param[in] points the finite ones define the position of the lattice
   * \param[in] edge in metres, positive */
  VoxelLattice(const PointView& points, double edge);

  double
  edge() const
  {
    return edge_;
  }

  /** \brief The lattice of twice the edge in which voxel (x, y, z) becomes a part of
   * (x / 2, y / 2, z / 2), for up to six doublings. */
  VoxelLattice
  coarser() const;

  /** \return false for points that are not finite or outside the lattice */
  bool
  locate(const Eigen::Vector3f& point, VoxelHit& hit) const
  {
    for (int axis = 0; axis < 3; ++axis)
      if (!locateAlong(axis, point[axis], hit.place[axis], hit.offset[axis]))
        return false;
    return true;
  }

  /** \brief As locate () for many points at once, with one array per axis.
   * \param[out] keys keys of their voxels, octant 0
   * \param[out] offsets offsets from the centre, in units of 2^-14 of an edge
   * \param[out] is_within false for points that are not finite or outside the lattice;
   * their key and offsets are undefined */
  template <std::size_t Capacity>
  void
  locate(const float (&points)[3][Capacity],
         std::size_t size,
         VoxelKey (&keys)[Capacity],
         std::int32_t (&offsets)[3][Capacity],
         bool (&is_within)[Capacity]) const
  {
    for (std::size_t k = 0; k < size; ++k) {
      keys[k] = 0;
      is_within[k] = true;
    }
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t k = 0; k < size; ++k) {
        std::int32_t place;
        is_within[k] &= locateAlong(axis, points[axis][k], place, offsets[axis][k]);
        keys[k] |= static_cast<VoxelKey>(place)
                   << ((2 - axis) * voxel_axis_bits + octant_bits);
      }
  }

  /** \brief Centre of a voxel, metres. */
  Eigen::Vector3d
  center(const VoxelPlace& place) const
  {
    Eigen::Vector3d result;
    for (int axis = 0; axis < 3; ++axis)
      result[axis] = (static_cast<double>(place[axis] + first_[axis]) + 0.5) * edge_;
    return result;
  }

private:
  void
  derive();

  /** Has no branches, for loops over many points. */
  bool
  locateAlong(int axis,
              float coordinate,
              std::int32_t& place,
              std::int32_t& offset) const
  {
    const double ticks = static_cast<double>(coordinate) * scale_ + shift_[axis];
    const bool is_within = ticks >= min_ticks && ticks < max_ticks;
    const auto whole = static_cast<std::int64_t>(is_within ? ticks : 0.0);
    place = static_cast<std::int32_t>(whole >> offset_bits);
    offset = static_cast<std::int32_t>(whole & ((1 << offset_bits) - 1)) -
             (1 << (offset_bits - 1));
    return is_within;
  }

  // a margin of voxels on all sides, so that windows can extend over the boundary
  static constexpr double margin = 8;
  static constexpr double min_ticks = margin * (1 << offset_bits);
  static constexpr double max_ticks =
      ((1 << voxel_axis_bits) - margin) * (1 << offset_bits);

  double edge_ = 1;
  // index of the first voxel in multiples of the edge
  std::array<std::int64_t, 3> first_{};
  double scale_ = 0;              // ticks per metre
  std::array<double, 3> shift_{}; // ticks
};

} // namespace pcl::acmap
