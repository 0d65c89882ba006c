#pragma once

#include <pcl/core/export.h>
#include <pcl/core/moments.h>
#include <pcl/core/point_view.h>
#include <pcl/core/sensor_view.h>
#include <pcl/core/voxel_lattice.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Packed red, green, blue of any point array, as PCL keeps them; nothing when
 * default-constructed. The companion of \ref PointView. \ingroup core */
struct ColorView {
  const void* first = nullptr; ///< the packed 32 bits of the array's first point
  std::size_t stride = 0;      ///< bytes

  explicit operator bool() const
  {
    return first != nullptr;
  }
};

/** \brief What a voxel's points sum up to, apart for each octant of directions in which
 * their sensors stood: the two sides of a thin wall never share a cell. \ingroup core */
struct VoxelCell {
  VoxelKey key = 0;
  Moments moments; ///< unit: voxel edge; origin: centre of the voxel

  /** \brief Position in the view of the point nearest to its sensor (the first one where
   * no sensor is known), and that distance in metres. */
  std::int32_t witness = 0;
  float range = 0;

  /** \brief Mean of the ways from the points to their sensors, metres; zero where no
   * sensor is known. */
  Eigen::Vector3f way = Eigen::Vector3f::Zero();
};

/** \brief Sums of three colour channels. */
struct ColorSum {
  std::uint64_t red = 0, green = 0, blue = 0;
};

/** \brief The occupied cells of a cloud, ascending by key.
 *
 * Sums are exact (integers of 2^-14 of an edge), so they do not depend on the order of
 * the points, nor on the number of threads. \ingroup core */
struct VoxelMoments {
  VoxelLattice lattice;
  std::vector<VoxelCell> cells;
  std::vector<ColorSum> colors;   ///< parallel to the cells; empty without a ColorView
  std::size_t invalid_points = 0; ///< not finite
  std::size_t distant_points = 0; ///< farther out than the lattice reaches
};

/** \brief Sums the points of each voxel up. Linear time, memory of the cells alone.
 * \param[in] points metres
 * \param[in] sensors who saw them
 * \param[in] edge of a voxel in metres, positive
 * \param[in] threads 0 for all */
ACMAP_EXPORT VoxelMoments
sumVoxels(const PointView& points,
          const SensorView& sensors,
          double edge,
          unsigned threads,
          const ColorView& colors = {});

/** \brief The same cloud at twice the edge; octants, ways and colours are dropped. */
ACMAP_EXPORT VoxelMoments
coarserVoxels(const VoxelMoments& fine);

} // namespace pcl::acmap
