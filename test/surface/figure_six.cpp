#include "figure_six.h"

#include <algorithm>
#include <deque>
#include <set>
#include <tuple>

namespace pcl::acmap::test {
namespace {

using Index = std::int32_t;
using Side = Triangle; // a side of the first two corners, and the third one
using Part = std::vector<Index>;

struct FigureSix {
  const Points& points;
  double longest;
  std::size_t leaf_size;
  Part cluster{};
  std::set<Triangle> found{};

  double
  squared(Index i, Index j) const
  {
    return (points[i] - points[j]).squaredNorm();
  }

  double
  dot(Index at, Index i, Index j) const
  {
    return (points[i] - points[at]).dot(points[j] - points[at]);
  }

  /** Square of twice the area. */
  double
  area(Index a, Index b, Index c) const
  {
    return squared(a, b) * squared(a, c) - dot(a, b, c) * dot(a, b, c);
  }

  bool
  isNear(Index i, Index j) const
  {
    return squared(i, j) <= longest * longest;
  }

  bool
  isBefore(Index i, Index j, int axis) const
  {
    return std::tie(points[i][axis], i) < std::tie(points[j][axis], j);
  }

  /** Of circles of one size: the larger angle a p b, then as if the point with the lowest
   * index were lowered. */
  bool
  winsTie(Index a, Index b, Index p, Index q) const
  {
    if ((dot(p, a, b) < 0) != (dot(q, a, b) < 0))
      return dot(p, a, b) < 0;
    if (std::min(p, q) < std::min(a, b))
      return p < q;
    const auto [low, high] = std::minmax(a, b);
    const double of_p = dot(low, high, p) * std::sqrt(area(a, b, q));
    const double of_q = dot(low, high, q) * std::sqrt(area(a, b, p));
    return of_p != of_q ? of_p > of_q : p < q;
  }

  /** |ap| |bp| / area is twice the ratio of the radius to |ab|. */
  bool
  isSmaller(Index a, Index b, Index p, Index q) const
  {
    const double left = squared(a, p) * squared(b, p) * area(a, b, q);
    const double right = squared(a, q) * squared(b, q) * area(a, b, p);
    return left != right ? left < right : winsTie(a, b, p, q);
  }

  bool
  isBeyondBeta(const Side& side, Index p) const
  {
    const auto [a, b, c] = side;
    return c < 0 || dot(a, c, p) * squared(a, b) < dot(a, b, c) * dot(a, b, p);
  }

  Index
  third(const Side& side) const
  {
    const auto [a, b, c] = side;
    Index best = -1;
    for (const Index p : cluster)
      if (p != a && p != b && area(a, b, p) > 0 && isBeyondBeta(side, p) &&
          (best < 0 || isSmaller(a, b, p, best)))
        best = p;
    if (best < 0 || !isNear(a, best) || !isNear(b, best))
      return -1;
    const auto [center, radius] =
        smallestCircumsphere(points[a], points[b], points[best]);
    for (Index i = 0; i < Index(points.size()); ++i)
      if (i != a && i != b && i != best &&
          (points[i] - center).norm() < (1 - 1e-6) * radius)
        return -1;
    return best;
  }

  Triangle
  first(Index plane, int axis) const
  {
    std::set<std::pair<double, Index>> nearest;
    for (const Index i : cluster)
      nearest.emplace(std::abs(points[i][axis] - points[plane][axis]), i);
    for (const auto& [distance, p1] : nearest) {
      std::set<std::pair<double, Index>> across;
      for (const Index j : cluster)
        if (isBefore(j, plane, axis) != isBefore(p1, plane, axis))
          across.emplace(squared(p1, j), j);
      const Index p2 = across.begin()->second;
      if (const Index p3 = isNear(p1, p2) ? third({p1, p2, -1}) : -1; p3 >= 0)
        return {p1, p2, p3};
    }
    return {-1, -1, -1};
  }

  bool
  add(Triangle corners)
  {
    std::sort(corners.begin(), corners.end());
    return found.insert(corners).second;
  }

  void
  build(Part part, std::deque<Side> cut)
  {
    Eigen::AlignedBox3d box;
    for (const Index i : part)
      box.extend(points[i]);
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    std::sort(part.begin(), part.end(), [&](Index i, Index j) {
      return isBefore(i, j, axis);
    });
    const auto middle = part.begin() + part.size() / 2;
    const Index plane = *middle;
    std::deque<Side> halves[2];
    const auto insert = [&](const Side& side) {
      const bool a = isBefore(side[0], plane, axis), b = isBefore(side[1], plane, axis);
      (part.size() <= leaf_size || a != b ? cut : halves[a ? 0 : 1]).push_back(side);
    };
    if (cut.empty())
      if (const auto [a, b, c] = first(plane, axis); c >= 0) {
        add({a, b, c});
        for (const Side& side : {Side{a, b, c}, Side{b, c, a}, Side{c, a, b}})
          insert(side);
      }
    while (!cut.empty()) {
      const Side side = cut.front();
      cut.pop_front();
      const auto [a, b, c] = side;
      if (const Index p = third(side); p >= 0 && add({a, b, p})) {
        insert({a, p, b});
        insert({p, b, a});
      }
    }
    if (!halves[0].empty())
      build(Part(part.begin(), middle), halves[0]);
    if (!halves[1].empty())
      build(Part(middle, part.end()), halves[1]);
  }
};

} // namespace

Triangles
figureSix(const Points& points, double longest, std::size_t leaf_size)
{
  FigureSix naive{points, longest, leaf_size};
  std::set<Index> rest;
  for (Index i = 0; i < Index(points.size()); ++i)
    rest.insert(i);
  while (!rest.empty()) {
    naive.cluster = {*rest.begin()};
    rest.erase(rest.begin());
    for (std::size_t next = 0; next < naive.cluster.size(); ++next)
      for (const Index j : Part(rest.begin(), rest.end()))
        if (naive.isNear(naive.cluster[next], j)) {
          naive.cluster.push_back(j);
          rest.erase(j);
        }
    if (naive.cluster.size() >= 3)
      naive.build(naive.cluster, {});
  }
  return {naive.found.begin(), naive.found.end()};
}

} // namespace pcl::acmap::test
