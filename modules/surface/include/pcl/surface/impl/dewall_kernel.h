#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/progress.h>
#include <pcl/core/sensor_evidence.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/surface/dewall_types.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Nearest neighbour search of the caller: returns the squared distances, in
 * square metres and any order, from a point of the array under the view to its nearest
 * \a count points, including itself. It is called by one thread at a time. */
using NeighbourDistances =
    std::function<std::vector<float>(std::int32_t point, int count)>;

/** \brief Settings of \ref triangulateDeWall; see DeWallTriangulation. */
struct DeWallSettings {
  DeWallRule rule = DeWallRule::Guarded;
  double maximum_edge_length = 0; ///< metres; 0: automatic
  bool compute_wall_depth = false;
  std::size_t memory_limit = 0; ///< bytes without the input; 0: no limit

  /** Unit vector; if set, no sensor is known, and surfaces face their free space. */
  std::optional<Eigen::Vector3d> up;

  bool outward = false; ///< no sensor is known, and surfaces face outward

  /** Halves with at most this number of points are not divided further; 0: 65536, with
   * Strict 1. The mesh depends on this number, so it must not depend on anything else,
   * such as the number of threads. */
  std::int32_t leaf_size = 0;
};

/** \brief What a run of \ref triangulateDeWall is given beside its settings. */
struct DeWallInput {
  PointView points;
  Eigen::Vector3d sensor_origin = Eigen::Vector3d::Zero();
  bool is_single_view = false; ///< all points were measured from there
  SensorEvidence sensor = {};  ///< is it the sensor's position?

  /** The points that the sensor measured, perhaps in rings, of which the points are a part or a
   * consolidation; empty: no rings. Automatic edges reach to the next ring. */
  PointView scan = {};

  /** Metres; where the rings are closer, the longest edge; 0: by the spacing. */
  double scan_edge = 0;

  /** Unit normals of the array under the points, towards the side from which they were
   * measured; empty: unknown. */
  PointView normals = {};

  NeighbourDistances neighbours = {}; ///< measures the spacing; empty: the tree does
  unsigned threads = 0;               ///< 0: all
};

/** \brief The kernel of DeWallTriangulation, independent of PCL's point types.
 * \param[out] report counts, seconds, remarks; it is reset first
 * \return index triples into the array under the points
 * \throws MemoryLimitException when the estimate exceeds the memory limit
 * \throws CancelledException when the progress callback requested to stop
 * \ingroup surface */
ACMAP_EXPORT TriangleMesh
triangulateDeWall(const DeWallInput& input,
                  const DeWallSettings& settings,
                  const Progress& progress,
                  DeWallReport& report);

/** \brief Sets \ref DeWallInput::sensor and \ref DeWallInput::is_single_view of points with an
 * origin. Points with normals are not asked unless they are a picture.
 * \param[in] width pixels per row; 0: unorganized
 * \param[in] is_stated is the origin the sensor's position, whatever the points say?
 * \ingroup surface */
ACMAP_EXPORT void
takeSensor(std::size_t width, bool is_stated, DeWallInput& input);

} // namespace pcl::acmap
