#include "figure_six.h"

#include <algorithm>
#include <limits>

namespace pcl::acmap::test {
namespace {

template <typename Part, typename Key>
Part
sorted(Part part, const Key& key)
{
  std::sort(part.begin(), part.end(), [&](auto i, auto j) { return key(i) < key(j); });
  return part;
}

} // namespace

/** Of circles of one size: the larger angle a p b, then as if the point with the lowest
 * index were lowered. Points on one line with a and b have an infinite circle. */
FigureSix::Circle
FigureSix::circle(Index a, Index b, Index p) const
{
  const double area = dot(a, b, b) * dot(a, p, p) - dot(a, b, p) * dot(a, b, p);
  const auto [low, high] = std::minmax(a, b);
  return {area > 0 ? dot(a, p, p) * dot(b, p, p) / area : none,
          dot(p, a, b) >= 0,
          p < low ? p : std::numeric_limits<Index>::max(),
          -dot(low, high, p) / std::sqrt(area),
          p};
}

FigureSix::Index
FigureSix::third(const Side& side)
{
  const auto [known, is_new] = thirds_.emplace(side, -1);
  if (!is_new)
    return known->second;
  const auto [a, b, c] = side;
  Circle best{none, false, -1, 0, -1};
  for (const Index p : cluster_)
    if (p != a && p != b && // beyond beta, c is not
        (c < 0 || dot(a, c, p) * dot(a, b, b) < dot(a, b, c) * dot(a, b, p)))
      best = std::min(best, circle(a, b, p));
  const Index p = std::get<4>(best);
  if (p < 0 || !isNear(a, p) || !isNear(b, p))
    return -1;
  const auto [center, radius] =
      smallestCircumsphere(points_[a], points_[b], points_[p]);
  for (const Index i : cluster_)
    if (i != a && i != b && i != p &&
        (points_[i] - center).norm() < (1 - 1e-6) * radius)
      return -1;
  return known->second = p;
}

Triangle
FigureSix::first(const std::function<bool(Index)>& isLeft, Index plane, int axis)
{
  for (const Index p1 : sorted(cluster_, [&](Index i) {
         return std::pair(std::abs(points_[i][axis] - points_[plane][axis]), i);
       })) {
    const Part across = sorted(cluster_, [&](Index j) {
      return std::tuple(isLeft(j) == isLeft(p1), dot(p1, j, j), j);
    });
    const Index p2 = across.front();
    if (const Index p3 = isNear(p1, p2) ? third({p1, p2, -1}) : -1; p3 >= 0)
      return {p1, p2, p3};
  }
  return {-1, -1, -1};
}

void
FigureSix::build(Part part, std::deque<Side> cut, std::optional<int> axis_before)
{
  Eigen::AlignedBox3d box;
  for (const Index i : part)
    box.extend(points_[i]);
  Eigen::Vector3d widths = box.sizes();
  if (axis_before)
    widths[*axis_before] = -1; // Fig. 5: the next plane is orthogonal to the one before
  int axis = 0;
  widths.maxCoeff(&axis);
  const auto place = [&](Index i) { return std::pair(points_[i][axis], i); };
  part = sorted(part, place);
  const auto middle = part.begin() + part.size() / 2;
  const auto isLeft = [&](Index i) { return place(i) < place(*middle); };
  const bool has_plane = part.size() > leaf_size_;
  const std::size_t before = found_.size();
  std::deque<Side> left, right;
  const auto add = [&](Triangle corners, const std::vector<Side>& sides) {
    std::sort(corners.begin(), corners.end());
    if (std::find(found_.begin(), found_.end(), corners) != found_.end())
      return;
    found_.push_back(corners);
    for (const Side& side : sides) {
      const bool is_cut = !has_plane || isLeft(side[0]) != isLeft(side[1]);
      (is_cut ? cut : isLeft(side[0]) ? left : right).push_back(side);
    }
  };
  if (cut.empty())
    if (const auto [a, b, c] = first(isLeft, *middle, axis); c >= 0)
      add({a, b, c}, {{a, b, c}, {b, c, a}, {c, a, b}});
  for (; !cut.empty(); cut.pop_front()) {
    const auto [a, b, c] = cut.front();
    if (const Index p = third({a, b, c}); p >= 0)
      add({a, b, p}, {{a, p, b}, {p, b, a}});
  }
  walls_ += has_plane && found_.size() > before;
  if (!left.empty())
    build(Part(part.begin(), middle), left, axis);
  if (!right.empty())
    build(Part(middle, part.end()), right, axis);
}

Triangles
FigureSix::mesh(std::size_t leaf_size)
{
  leaf_size_ = leaf_size;
  walls_ = 0;
  found_.clear();
  std::vector<bool> is_taken(points_.size());
  for (Index seed = 0; seed < Index(points_.size()); ++seed) {
    cluster_ = is_taken[seed] ? Part() : Part{seed};
    is_taken[seed] = true;
    for (std::size_t next = 0; next < cluster_.size(); ++next)
      for (Index j = 0; j < Index(points_.size()); ++j)
        if (!is_taken[j] && isNear(cluster_[next], j)) {
          cluster_.push_back(j);
          is_taken[j] = true;
        }
    if (cluster_.size() >= 3)
      build(cluster_, {}, std::nullopt);
  }
  return found_;
}

} // namespace pcl::acmap::test
