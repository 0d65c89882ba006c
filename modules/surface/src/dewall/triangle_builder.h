#pragma once

#include "front.h"
#include "refill.h"

#include <vector>

namespace pcl::acmap::dewall {

/** \brief What one task of the recursion made: a wall, or a leaf's part of the mesh. */
struct Part {
  PointTree::Node node;
  std::int32_t first_component = 0; ///< its components are numbered from here, those of
                                    ///< the walls above below
  std::int32_t components = 0;
  std::vector<GrownTriangle> triangles;
  std::vector<Joint> joints;
  std::vector<Side> deferred; ///< left to the last pass with all doubts
  Unfinished unfinished;      ///< left to the last pass without pinches
  std::size_t refused_moebius = 0;
  std::size_t removed_fans = 0;
};

/** \brief How the parts are made. */
struct BuilderSettings {
  DeWallRule rule;
  std::int32_t leaf_size; ///< halves of at most so many points are not divided further
};

/** \brief Triangle_Builder of [P] Fig. 6: first the wall of the splitting plane, then
 * each half, as a task of its own, with apexes of its own.
 *
 * A leaf of the recursion also does the last passes, for what lies inside it.
 * \return the parts in the order of a heap: the children of part i are 2 i + 1, 2 i + 2 */
std::vector<Part>
buildTriangles(MeshArrays& arrays,
               const SizeConstraint& size,
               const BuilderSettings& settings,
               const std::function<void()>& tick);

} // namespace pcl::acmap::dewall
