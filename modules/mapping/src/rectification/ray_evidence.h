#pragma once

#include "wall_table.h"

#include <pcl/mapping/rectification_kernel.h>

#include <vector>

namespace pcl::acmap {

/** \brief Asks the rays whether a map can be: what lies before the end of a ray was free
 * when it was seen, whatever the entropy says. */
class RayEvidence {
public:
  /** \param[in] bin_size of the finest level, metres: cells of walls are twice as wide */
  RayEvidence(const std::vector<LevelledPoints>& observations, double bin_size);

  /** \brief The shares of \ref MapEvidence that rays tell. */
  void
  judge(const std::vector<PlanarPose>& poses, MapEvidence& evidence) const;

private:
  struct Ray;
  struct Counts;

  Counts
  castRays(std::size_t observation,
           const PlanarPose& pose,
           const WallTable& table) const;

  /** \brief Of points of walls in a cell that others have seen, those for which
   * \a counts (cosine of a direction and the wall's normal) is true: near, far. */
  template <typename Predicate>
  void
  countWalls(const Ray& ray,
             std::uint64_t cell,
             const WallTable& table,
             const Eigen::Vector2d& direction,
             const Predicate& counts,
             std::size_t points[2]) const;

  const std::vector<LevelledPoints>& observations_;
  double cell_;           ///< metres, edge
  std::size_t every_ = 1; ///< point is a ray
  bool has_normals_ = false;
};

} // namespace pcl::acmap
