#pragma once

#include "apex_search.h"
#include "range.h"
#include "unused_points.h"

#include <pcl/surface/dewall_types.h>

#include <functional>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief A triangle of the dense rule that the guard rejected. */
struct Refusal {
  Side side;
  std::int32_t apex;
};

/** \brief Open cases of a refill. */
struct Unfinished {
  std::vector<Side> sides;          ///< points outside of the range might close them
  std::vector<std::int32_t> points; ///< unused, with points outside of the range near
  std::vector<Refusal> refusals;    ///< to be tried again after changes
};

/** \brief Completes the mesh of a range of points without pinching a vertex.
 *
 * All apexes of open edges and all triangles of neighbouring unused points are tried. A
 * rejected triangle can become permitted only by a new open edge, which is tried as
 * well: at the end of the pass, no permitted triangle is left. With the dense rule an
 * edge has only one apex, the Delaunay-nearest; rejected ones are tried again until
 * nothing changes. */
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
  , unused_(mesh.arrays(), size, range_)
  , tick_(std::move(tick))
  {}

  /** \param[in] begun open edges, unused points and rejected triangles to begin with
   * \return cases that may be continued outside of the range */
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
  closeSideDensely(const Side& side, Edge* base, const SideFrame& frame);

  bool
  closeWith(const Proposal& proposal);

  enum class Ties { Matter, DoNotMatter };

  /** \brief Returns false if points outside of the range might have helped. */
  bool
  startAt(std::int32_t p1, Ties ties);

  /** \brief Finds the apexes in order of Delaunay distance. */
  void
  findApexes(const Side& side, const SideFrame& frame);

  void
  close(const Proposal& proposal);

  bool
  fits(const Proposal& proposal);

  const PointTree& tree_;
  const SizeConstraint& size_;
  const DeWallRule rule_;
  GrowingMesh& mesh_;
  const Range range_;
  UnusedPoints unused_;
  std::function<void()> tick_;
  std::vector<Side> queue_;
  Unfinished left_;
  std::vector<std::int32_t> found_; ///< reused memory
  std::vector<Apex> apexes_;        ///< reused memory
  bool is_at_wall_ = false;         ///< at the last edge; it may have more apexes
};

/** \brief Returns the edges that may be closed and the points that may be used after
 * triangles were removed: the open edges at their corners, and those in reach of
 * corners that are no longer used. */
Unfinished
affectedBy(const std::vector<GrownTriangle>& removed,
           const SizeConstraint& size,
           GrowingMesh& mesh);

} // namespace pcl::acmap::ACMAP_DEWALL
