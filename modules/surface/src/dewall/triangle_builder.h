#pragma once

#include "front.h"
#include "refill.h"

#include <vector>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief Result of one task of the recursion: a wall, or the part of the mesh in a
 * leaf. */
struct Part {
  PointTree::Node node;
  std::int32_t first_component = 0; ///< lower numbers are those of the walls above
  std::int32_t components = 0;
  GrownTriangles triangles; ///< in the store of the arrays
  std::vector<Joint> joints;
  std::vector<Side> deferred; ///< left to the last pass, including doubtful triangles
  Unfinished unfinished;      ///< left to the last pass without pinches
  std::size_t refused_moebius = 0;
  std::size_t removed_fans = 0;
};

/** \brief Settings of \ref buildTriangles. */
struct BuilderSettings {
  DeWallRule rule;
  std::int32_t leaf_size; ///< maximum number of points of an undivided half
};

/** \brief Triangle_Builder of [P] Fig. 6: first the wall of the splitting plane is
 * built, then each half in a task of its own, with apexes of its own.
 *
 * A leaf of the recursion also performs the last passes within its range.
 * \return the parts in heap order: the children of part i are 2 i + 1 and 2 i + 2 */
std::vector<Part>
buildTriangles(MeshArrays& arrays,
               const SizeConstraint& size,
               const BuilderSettings& settings,
               const std::function<void()>& tick);

} // namespace pcl::acmap::ACMAP_DEWALL
