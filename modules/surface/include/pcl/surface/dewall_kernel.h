#pragma once

#include <pcl/core/export.h>
#include <pcl/core/point_view.h>
#include <pcl/core/progress.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/surface/dewall_types.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace pcl::acmap {

/** \brief A search of the caller's: squared distances, in square metres and any order,
 * from a point of the array under the view to its nearest \a count points, itself
 * included. Called by one thread at a time. */
using NeighbourDistances =
    std::function<std::vector<float>(std::int32_t point, int count)>;

/** \brief Settings of \ref triangulateDeWall; see DeWallTriangulation. */
struct DeWallSettings {
  DeWallRule rule = DeWallRule::Paper;
  double maximum_edge_length = 0; ///< metres; 0: automatic
  bool compute_wall_depth = false;
  unsigned threads = 0;         ///< 0: all
  std::size_t memory_limit = 0; ///< bytes beside the input; 0: none
  Eigen::Vector3d sensor_origin = Eigen::Vector3d::Zero();
  bool is_single_view = false; ///< every point was seen from there

  /** Unit normals of the array under the points, off the side from which they were seen;
   * empty: unknown. */
  PointView normals;

  NeighbourDistances neighbours; ///< who tells the spacing; empty: the kernel's cells

  /** Halves of at most so many points are grown without a further wall. The mesh
   * depends on it, so it depends on nothing else. */
  std::int32_t leaf_size = 65536;
};

/** \brief The kernel behind DeWallTriangulation, free of PCL's point types.
 * \param[in] view the points
 * \param[out] report counts, seconds, remarks; begun anew
 * \return index triples into the array under the view
 * \throws MemoryLimitException when the estimate exceeds the memory limit
 * \throws CancelledException when the progress was told to stop \ingroup surface */
ACMAP_EXPORT TriangleMesh
triangulateDeWall(const PointView& view,
                  const DeWallSettings& settings,
                  const Progress& progress,
                  DeWallReport& report);

/** \brief Are these the pixels of one camera that stood at \a origin, row by row?
 *
 * The rays to a pixel, its right and its lower neighbour turn the same way round all over
 * an image, whatever the depths. A cloud that was moved after it was taken fails.
 * \param[in] width pixels a row \ingroup surface */
ACMAP_EXPORT bool
isSingleView(const PointView& view, std::size_t width, const Eigen::Vector3d& origin);

} // namespace pcl::acmap
