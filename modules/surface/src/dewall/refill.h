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
 * has but one apex, the Delaunay-nearest; those refused are asked again until nothing
 * changes. */
class Refill {
public:
  Refill(const PointTree& tree,
         const SizeConstraint& size,
         DeWallRule rule,
         GrowingMesh& mesh,
         std::function<void()> tick);

  void
  run();

private:
  struct Refusal {
    Side side;
    std::int32_t apex;
  };

  void
  workOff();

  void
  reconsider();

  void
  closeSide(const Side& side);

  bool
  closeWith(const Side& side, std::int32_t apex);

  enum class Ties { Matter, DoNotMatter };

  void
  startAt(std::int32_t p1, Ties ties);

  std::vector<std::int32_t>
  apexesByDistance(const Side& side, const SideFrame& frame) const;

  std::vector<std::int32_t>
  unusedWithin(double radius, const Eigen::Vector3d& centre, std::int32_t start) const;

  bool
  fits(const Side& side, std::int32_t apex);

  void
  noteLastTriangle();

  void
  turnEdge(std::int32_t a, std::int32_t b);

  const PointTree& tree_;
  const SizeConstraint& size_;
  const DeWallRule rule_;
  GrowingMesh& mesh_;
  std::function<void()> tick_;
  std::vector<Side> queue_;
  std::vector<Refusal> refused_;
  /** For each point its open neighbours: two, three while a triangle is noted. */
  std::vector<std::array<std::int32_t, 3>> rim_;
  std::vector<std::int32_t> unused_; ///< for each node its unused points
  std::vector<bool> counted_;        ///< for each point: it left unused_
};

} // namespace pcl::acmap::dewall
