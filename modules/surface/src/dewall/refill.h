#pragma once

#include "apex_search.h"
#include "range.h"

#include <pcl/surface/dewall_types.h>

#include <functional>

namespace pcl::acmap::dewall {

/** \brief A triangle of the dense rule that the guard refused. */
struct Refusal {
  Side side;
  std::int32_t apex;
};

/** \brief What a refill leaves open. */
struct Unfinished {
  std::vector<Side> sides;          ///< points beyond the range might close them
  std::vector<std::int32_t> points; ///< unused, with points beyond the range in reach
  std::vector<Refusal> refusals;    ///< to be asked again where something changes
};

/** \brief Completes the mesh of a range of points without ever pinching a vertex.
 *
 * Open sides try all of their apexes, unused points all triangles of unused points round
 * them. An earlier refusal can become legal only by a new open side, which is tried
 * itself: when the pass ends, no legal triangle is left. With the dense rule a side has
 * but one apex, the Delaunay-nearest; those refused are asked again until nothing
 * changes. */
class Refill {
public:
  Refill(const SizeConstraint& size,
         DeWallRule rule,
         GrowingMesh& mesh,
         const Range& range,
         std::function<void()> tick)
  : tree_(mesh.arrays().tree)
  , size_(size)
  , rule_(rule)
  , mesh_(mesh)
  , range_(range)
  , tick_(std::move(tick))
  {}

  /** \param[in] begun open sides, unused points and refusals to begin with
   * \return what may go on beyond the range */
  Unfinished
  run(Unfinished begun);

private:
  void
  workOff();

  void
  reconsider();

  void
  closeSide(const Side& side);

  void
  closeSideDensely(const Side& side, const SideFrame& frame);

  bool
  closeWith(const Side& side, std::int32_t apex);

  enum class Ties { Matter, DoNotMatter };

  /** \brief False when points beyond the range might have helped. */
  bool
  startAt(std::int32_t p1, Ties ties);

  /** \brief Indices of the apexes, the Delaunay-nearest first. */
  void
  findApexes(const Side& side, const SideFrame& frame);

  /** \brief Finds the points inside a ball that are unused, or beyond the range.
   * \param[in] inward unit normal of a plane through the start, behind which none is
   * wanted; zero: everywhere
   * \return false when the ball touches leaves beyond the range */
  bool
  findUnused(double radius,
             const Eigen::Vector3d& centre,
             std::int32_t start,
             const Eigen::Vector3f& inward);

  bool
  fits(const Side& side, std::int32_t apex);

  const PointTree& tree_;
  const SizeConstraint& size_;
  const DeWallRule rule_;
  GrowingMesh& mesh_;
  const Range range_;
  std::function<void()> tick_;
  std::vector<Side> queue_;
  Unfinished left_;
  std::vector<std::int32_t> found_; ///< unused points, kept for its memory
  std::vector<Apex> apexes_;        ///< as found_
  bool is_at_wall_ = false; ///< the side last looked at: it may have more apexes
};

/** \brief Sides that may close, and points that may be used, now that triangles are gone:
 * the open sides at their corners, and what is in reach of corners no longer used. */
Unfinished
affectedBy(const std::vector<GrownTriangle>& removed,
           const SizeConstraint& size,
           GrowingMesh& mesh);

} // namespace pcl::acmap::dewall
