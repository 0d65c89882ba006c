#pragma once

#include "wall_table.h"

#include <pcl/mapping/impl/rectification_kernel.h>

#include <vector>

namespace pcl::acmap {

/** \brief Verifies a map by its rays: the space before the end of a ray was free when
 * it was measured. The entropy does not use this information. */
class RayEvidence {
public:
  /** \param[in] bin_size of the finest level, metres: the cells of walls are twice as
   * wide, but within [0.1, 0.2] m */
  RayEvidence(const std::vector<LevelledPoints>& observations, double bin_size);

  /** \brief Computes the shares of \ref MapEvidence that are derived from rays. */
  void
  judge(const std::vector<PlanarPose>& poses, MapEvidence& evidence) const;

private:
  struct Ray;
  struct Counts;
  class Crossing;

  Counts
  castRays(std::size_t observation,
           const PlanarPose& pose,
           const WallTable& table) const;

  /** \brief Visits the walls in a cell that were seen by other observations and for
   * which \a counts (cosine between a direction and the normal of the wall) returns
   * true: visit (observation, points), in the order of the observations. */
  template <typename Predicate, typename Visit>
  void
  visitWalls(const Ray& ray,
             std::uint64_t cell,
             const WallTable& table,
             const Eigen::Vector2d& direction,
             const Predicate& counts,
             const Visit& visit) const;

  /** \brief Computes the shares of pairs of groups. */
  void
  judgePairs(const std::vector<Counts>& counts, MapEvidence& evidence) const;

  std::size_t
  groups() const
  {
    return (observations_.size() + group_ - 1) / group_;
  }

  const std::vector<LevelledPoints>& observations_;
  double cell_;           ///< metres, edge length
  std::size_t every_ = 1; ///< every n-th point is used as a ray
  std::size_t group_;     ///< successive observations that form a group
  bool has_normals_ = false;
};

} // namespace pcl::acmap
