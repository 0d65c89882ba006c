#pragma once

#include "range.h"
#include "size_constraint.h"

#include <vector>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief A ball in which unused points are searched. */
struct UnusedQuery {
  std::int32_t at; ///< a point of the tree at the ball
  Eigen::Vector3d centre;
  double radius;
  Eigen::Vector3f inward; ///< normal of a plane through the point: points behind it are
                          ///< not needed; zero: no plane
};

/** \brief Finds unused points while a range is refilled, in which points become used but
 * never unused. Of points outside of the range it is unknown whether they are used.
 *
 * The unused points near a leaf are listed once, because many edges begin there. */
class UnusedPoints {
public:
  UnusedPoints(const MeshArrays& arrays, const SizeConstraint& size, const Range& range)
  : arrays_(arrays)
  , tree_(arrays.tree)
  , size_(size)
  , range_(range)
  , lists_(static_cast<std::size_t>(range.end_leaf - range.first_leaf))
  {}

  /** \brief Finds the points in a ball that are unused or outside of the range, at least
   * those within the maximum edge length of the query's point; others may be among
   * them.
   * \return false if the ball intersects leaves outside of the range */
  bool
  find(const UnusedQuery& query, std::vector<std::int32_t>& found);

private:
  /** The points near a leaf that were unused when the list was made. */
  struct List {
    static constexpr std::size_t max_size = 32;
    enum class State : std::uint8_t { Unmade, Made, Refused };

    std::uint32_t begin = 0;
    std::uint8_t size = 0;
    State state = State::Unmade;
  };

  /** \brief Makes a list, unless it would be long or leaves outside of the range are
   * near. */
  void
  makeList(std::int32_t leaf, List& list);

  bool
  walk(const UnusedQuery& query, std::vector<std::int32_t>& found) const;

  bool
  isOwn(std::int32_t leaf) const
  {
    return leaf >= range_.first_leaf && leaf < range_.end_leaf;
  }

  /** \brief Returns a bit for each member of a group that may have such points. */
  unsigned
  membersWithUnused(int level, std::int32_t group) const;

  const MeshArrays& arrays_;
  const PointTree& tree_;
  const SizeConstraint& size_;
  const Range& range_;
  LargeVector<List> lists_;           ///< of each leaf of the range
  std::vector<std::int32_t> members_; ///< of all lists
  std::vector<std::int32_t> near_;    ///< reused memory
};

} // namespace pcl::acmap::ACMAP_DEWALL
