#pragma once

#include "mesh_checker.h"

#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace pcl::acmap::test {

/** \brief Fig. 6 of the paper by brute force: connected clusters, then Triange_Builder for
 * each of them, which tests all points at every step.
 *
 * It shares no code with the product. Doubles have to be exact enough: either the points
 * are in general position, or their coordinates are small integers. */
class FigureSix {
public:
  /** \param[in] longest size constraint */
  FigureSix(const Points& points, double longest)
  : points_(points)
  , longest_(longest)
  {}

  /** \param[in] leaf_size a part of at most this number of points has no splitting plane
   * \return the triangles in the order in which they are found, as sorted vertices */
  Triangles
  mesh(std::size_t leaf_size);

  /** \brief Number of calls of the last mesh that have a plane and found a triangle. */
  std::size_t
  walls() const
  {
    return walls_;
  }

private:
  using Index = std::int32_t;
  using Part = std::vector<Index>;
  using Side = Triangle; ///< a side of the first two corners, and the third one or -1
  using Circle =
      std::tuple<double, bool, Index, double, Index>; ///< the first is chosen

  double
  dot(Index at, Index i, Index j) const
  {
    return (points_[i] - points_[at]).dot(points_[j] - points_[at]);
  }

  bool
  isNear(Index i, Index j) const
  {
    return dot(i, j, j) <= longest_ * longest_;
  }

  Circle
  circle(Index a, Index b, Index p) const;

  Index
  third(const Side& side);

  Triangle
  first(const std::function<bool(Index)>& isLeft, Index plane, int axis);

  void
  build(Part part, std::deque<Side> cut, std::optional<int> axis_before);

  static constexpr double none = std::numeric_limits<double>::infinity();
  const Points points_;
  const double longest_;
  std::map<Side, Index> thirds_; ///< do not depend on planes
  std::size_t leaf_size_ = 0, walls_ = 0;
  Part cluster_;
  Triangles found_;
};

} // namespace pcl::acmap::test
