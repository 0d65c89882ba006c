#include "literal_builder.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

/** \brief Open-addressing set of triangles, whatever the order of their corners. */
class TriangleSet {
public:
  /** \brief Returns false if the last triangle of the list is there already. */
  bool
  insertLast(const std::vector<LiteralTriangle>& list)
  {
    if (2 * list.size() > slots_.size())
      grow(list);
    std::int32_t& slot = slotOf(list, list.back().corners);
    if (slot >= 0)
      return false;
    slot = static_cast<std::int32_t>(list.size()) - 1;
    return true;
  }

private:
  using Corners = std::array<std::int32_t, 3>;

  static Corners
  sorted(Corners corners)
  {
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  std::int32_t&
  slotOf(const std::vector<LiteralTriangle>& list, const Corners& corners)
  {
    const Corners key = sorted(corners);
    std::uint64_t hash = 0x9e3779b97f4a7c15u;
    for (const std::int32_t corner : key) {
      hash = (hash ^ static_cast<std::uint64_t>(corner)) * 0xbf58476d1ce4e5b9u;
      hash ^= hash >> 29;
    }
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash & mask;
    while (slots_[slot] >= 0 &&
           sorted(list[static_cast<std::size_t>(slots_[slot])].corners) != key)
      slot = (slot + 1) & mask;
    return slots_[slot];
  }

  /** The last triangle of the list is not in the set yet. */
  void
  grow(const std::vector<LiteralTriangle>& list)
  {
    slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), -1);
    for (std::size_t t = 0; t + 1 < list.size(); ++t)
      slotOf(list, list[t].corners) = static_cast<std::int32_t>(t);
  }

  std::vector<std::int32_t> slots_;
};

class LiteralBuilder {
public:
  LiteralBuilder(const LiteralPoints& points,
                 std::int32_t leaf_size,
                 const std::function<void()>& tick)
  : points_(points)
  , leaf_size_(std::max(leaf_size, 1))
  , tick_(tick)
  , order_(static_cast<std::size_t>(points.size()))
  {
    std::iota(order_.begin(), order_.end(), 0);
  }

  LiteralMesh
  run()
  {
    build({0, points_.size(), 0, -1}, {});
    return std::move(result_);
  }

private:
  using Sides = std::vector<TriangleSide>;

  /** The points of a call, a range of the order, of which it takes its plane. */
  struct Part {
    std::int32_t begin, end;
    int depth;
    int axis_before; ///< of the plane of the call before; -1: none
  };

  /** The three lists of a call. */
  struct Lists {
    Sides cut, left, right; ///< L_alpha, L_l, L_r
  };

  /** \brief Triange_Builder (P, L_alpha), with the line numbers of Fig. 6. */
  void
  build(const Part& part, Sides sides)
  {
    const std::size_t before = result_.triangles.size();
    const std::int32_t middle = part.begin + (part.end - part.begin) / 2;
    const SplittingPlane alpha = divide(part, middle);
    const bool has_wall = part.end - part.begin > leaf_size_;
    const SplittingPlane* plane = has_wall ? &alpha : nullptr;
    Lists lists{std::move(sides), {}, {}};
    if (lists.cut.empty())                                       // 6
      if (const auto first = points_.findFirstTriangle(alpha)) { // 7
        const auto [a, b, c] = *first;
        add(*first, part); // 8
        for (const TriangleSide& side : {TriangleSide{a, b, c}, {b, c, a}, {c, a, b}})
          insert(side, plane, lists); // 9 to 12
      }
    advance(part, plane, lists); // 13 to 21
    result_.walls += has_wall && result_.triangles.size() > before;
    lists.cut = {};
    if (!lists.left.empty()) // 22
      build({part.begin, middle, part.depth + 1, alpha.axis}, std::move(lists.left));
    if (!lists.right.empty()) // 23
      build({middle, part.end, part.depth + 1, alpha.axis}, std::move(lists.right));
  }

  /** \brief The while loop, lines 13 to 21. */
  void
  advance(const Part& part, const SplittingPlane* plane, Lists& lists)
  {
    std::vector<std::int32_t> apexes;
    while (!lists.cut.empty()) {
      const Sides sides = std::exchange(lists.cut, {}); // 14, first in first out
      findTriangles(sides, apexes);                     // 15
      for (std::size_t i = 0; i < sides.size(); ++i) {
        const auto [a, b, opposite] = sides[i];
        const std::int32_t apex = apexes[i];
        if (apex < 0 || !add({b, a, apex}, part)) // 16, 17
          continue;
        insert({a, apex, b}, plane, lists); // 18 to 21
        insert({apex, b, a}, plane, lists);
      }
    }
  }

  /** \brief FindTriangle for all sides that are waiting now. It does not depend on the
   * triangles that were found, so the result is the same as one by one. */
  void
  findTriangles(const Sides& sides, std::vector<std::int32_t>& apexes)
  {
    constexpr std::size_t grain = 16;
    apexes.resize(sides.size());
    const auto find = [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        apexes[i] = points_.findTriangle(sides[i]);
        tick_();
      }
    };
    if (sides.size() < 2 * grain)
      find(0, sides.size());
    else
      oneapi::tbb::parallel_for(
          oneapi::tbb::blocked_range<std::size_t>(0, sides.size(), grain),
          [&](const auto& range) { find(range.begin(), range.end()); });
  }

  /** \brief Adds a triangle to the set; returns false if it is in it already. */
  bool
  add(const std::array<std::int32_t, 3>& corners, const Part& part)
  {
    result_.triangles.push_back({corners, static_cast<std::uint8_t>(part.depth)});
    const bool is_new = set_.insertLast(result_.triangles);
    if (!is_new)
      result_.triangles.pop_back();
    return is_new;
  }

  /** \brief IsIntersected, InHalfSpaceL and InHalfSpaceR. */
  void
  insert(const TriangleSide& side, const SplittingPlane* plane, Lists& lists)
  {
    const bool is_a_left = plane && points_.isLeft(side.a, *plane);
    const bool is_b_left = plane && points_.isLeft(side.b, *plane);
    const bool is_cut = !plane || is_a_left != is_b_left;
    (is_cut ? lists.cut : is_a_left ? lists.left : lists.right).push_back(side);
  }

  /** \brief Orders the part so that its points before \a middle are left of the plane, which is
   * orthogonal to the one before (Fig. 5), across the wider of the two axes that are left. */
  SplittingPlane
  divide(const Part& part, std::int32_t middle)
  {
    SplittingPlane alpha;
    const auto begin = order_.begin() + part.begin, end = order_.begin() + part.end;
    float widest = -1;
    for (int axis = 0; axis < 3; ++axis) {
      if (axis == part.axis_before)
        continue;
      const auto [low, high] =
          std::minmax_element(begin, end, [&](std::int32_t i, std::int32_t j) {
            return points_.coordinate(i, axis) < points_.coordinate(j, axis);
          });
      const float width =
          points_.coordinate(*high, axis) - points_.coordinate(*low, axis);
      if (width > widest) {
        widest = width;
        alpha.axis = axis;
      }
    }
    std::nth_element(
        begin, order_.begin() + middle, end, [&](std::int32_t i, std::int32_t j) {
          return points_.comesBefore(i, j, alpha.axis);
        });
    alpha.point = order_[static_cast<std::size_t>(middle)];
    return alpha;
  }

  const LiteralPoints& points_;
  const std::int32_t leaf_size_;
  const std::function<void()>& tick_;
  std::vector<std::int32_t> order_;
  TriangleSet set_;
  LiteralMesh result_;
};

} // namespace

LiteralMesh
buildLiterally(const LiteralPoints& points,
               std::int32_t leaf_size,
               const std::function<void()>& tick)
{
  return LiteralBuilder(points, leaf_size, tick).run();
}

} // namespace pcl::acmap::ACMAP_DEWALL
