#pragma once

#include "apex_search.h"
#include "growing_mesh.h"

#include <pcl/core/triangle_mesh.h>
#include <pcl/surface/dewall_types.h>

#include <functional>

namespace pcl::acmap::dewall {

/** \brief The last sequential pass: completes the mesh without ever pinching a vertex.
 *
 * Every open side tries all of its apexes, every unused point all triangles of unused
 * points round it. An earlier refusal can become legal only by a new open side, which is
 * tried itself: when the pass ends, no legal triangle is left. With the dense rule a side
 * has but one apex, the Delaunay-nearest, so that the other side may have to be asked
 * again: the pass is repeated until nothing changes.
 */
class Refill {
public:
  Refill(const PointTree& tree,
         const SizeConstraint& size,
         DeWallRule rule,
         GrowingMesh& mesh,
         std::function<void()> tick)
  : tree_(tree)
  , size_(size)
  , rule_(rule)
  , mesh_(mesh)
  , tick_(std::move(tick))
  {}

  void
  run();

private:
  void
  workOff();

  void
  closeSide(const Side& side);

  std::vector<std::int32_t>
  fittingApexes(const Side& side, const SideFrame& frame);

  void
  startAt(std::int32_t p1);

  bool
  isEmpty(const std::array<std::int32_t, 3>& corners) const;

  const PointTree& tree_;
  const SizeConstraint& size_;
  const DeWallRule rule_;
  GrowingMesh& mesh_;
  std::function<void()> tick_;
  std::vector<Side> queue_;
};

} // namespace pcl::acmap::dewall
