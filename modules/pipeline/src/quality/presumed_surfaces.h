#pragma once

#include <pcl/pipeline/unseen_surfaces.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief A wall of a plan that probably goes on where nobody looked; it hides what is behind it. */
struct PresumedWall {
  Eigen::Vector2d from, to; ///< metres of the plan; from is where the seen wall ends
};

/** \brief What views can uncover. */
struct PresumedSurfaces {
  /** \brief The unseen patches of the rooms, without those at their open ends, and what is presumed
   * beyond these; the area of the latter is what is expected of it. */
  std::vector<UnseenPatch> patches;
  std::vector<PresumedWall> walls;
};

/** \brief Continues floors, ceilings and walls beyond the open ends of rooms, by 4 m. */
PresumedSurfaces
presumedSurfaces(const FloorPlan& plan, const UnseenSurfaces& unseen);

/** \brief Does a presumed wall stand between two places? */
bool
isBehindPresumed(const std::vector<PresumedWall>& walls,
                 const Eigen::Vector2d& eye,
                 const Eigen::Vector2d& place);

} // namespace pcl::acmap
