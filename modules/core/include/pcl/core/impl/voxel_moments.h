#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/large_memory.h>
#include <pcl/core/impl/moments.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/impl/voxel_lattice.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/core/sensor_view.h>

#include <cstdint>

namespace pcl::acmap {

/** \brief Packed colours (red, green, blue) of any point array, as stored by PCL; empty
 * if default-constructed. It is used together with a \ref PointView. \ingroup core */
struct ColorView {
  const void* first = nullptr; ///< the packed 32 bits of the array's first point
  std::size_t stride = 0;      ///< bytes

  explicit operator bool() const
  {
    return first != nullptr;
  }
};

/** \brief Sums over the points of a voxel, separate for each octant of directions to
 * their sensors: the two sides of a thin wall are never in the same cell. \ingroup core
 */
struct VoxelCell {
  VoxelKey key = 0;
  Moments moments; ///< unit: voxel edge; origin: centre of the voxel

  /** \brief Index in the view of the point closest to its sensor (the first point if no
   * sensor is known), and its distance in metres. */
  std::int32_t witness = 0;
  float range = 0;

  /** \brief Mean of the vectors from the points to their sensors, metres; zero if no
   * sensor is known. */
  Eigen::Vector3f way = Eigen::Vector3f::Zero();
};

/** \brief Sums of three colour channels. */
struct ColorSum {
  std::uint64_t red = 0, green = 0, blue = 0;
};

/** \brief The occupied cells of a cloud, in ascending order of keys.
 *
 * Sums are exact (integers of 2^-14 of an edge), so they do not depend on the order of
 * the points or on the number of threads. \ingroup core */
struct VoxelMoments {
  VoxelLattice lattice;
  UnfilledArray<VoxelCell> cells;
  UnfilledArray<ColorSum> colors; ///< parallel to the cells; empty without a ColorView
  std::size_t invalid_points = 0; ///< number of points that are not finite
  std::size_t distant_points = 0; ///< number of points outside the lattice
};

/** \brief Sums the points of each voxel. Takes linear time, and memory only for the
 * cells.
 * \param[in] points metres
 * \param[in] sensors sensor positions of the points
 * \param[in] edge of a voxel in metres, positive
 * \param[in] threads 0 for all */
ACMAP_EXPORT VoxelMoments
sumVoxels(const PointView& points,
          const SensorView& sensors,
          double edge,
          unsigned threads,
          const ColorView& colors = {});

/** \brief The moments of the same cloud at twice the edge; octants, directions to the
 * sensors and colours are dropped. */
ACMAP_EXPORT VoxelMoments
coarserVoxels(const VoxelMoments& fine);

} // namespace pcl::acmap
