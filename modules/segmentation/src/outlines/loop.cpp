#include "outlines/loop.h"

#include <pcl/core/impl/polyline_corners.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::outlines {
namespace {

std::size_t
farthestFrom(const Loop& loop, const Eigen::Vector2d& point)
{
  std::size_t best = 0;
  for (std::size_t i = 1; i < loop.size(); ++i)
    if ((loop[i] - point).squaredNorm() > (loop[best] - point).squaredNorm())
      best = i;
  return best;
}

/** Finds the first intersection of the segment that begins at \a i with a later one.
 * \return where that one begins, 0 for none */
std::size_t
firstCrossing(const Loop& loop, std::size_t i, Eigen::Vector2d& place)
{
  const std::size_t size = loop.size();
  for (std::size_t j = i + 2; j < size; ++j)
    if (segmentsCross(loop[i], loop[i + 1], loop[j], loop[(j + 1) % size], place))
      return j;
  return 0;
}

} // namespace

bool
segmentsCross(const Eigen::Vector2d& a,
              const Eigen::Vector2d& b,
              const Eigen::Vector2d& c,
              const Eigen::Vector2d& d,
              Eigen::Vector2d& place)
{
  const double c_side = cross(Eigen::Vector2d(b - a), Eigen::Vector2d(c - a));
  const double d_side = cross(Eigen::Vector2d(b - a), Eigen::Vector2d(d - a));
  const double a_side = cross(Eigen::Vector2d(d - c), Eigen::Vector2d(a - c));
  const double b_side = cross(Eigen::Vector2d(d - c), Eigen::Vector2d(b - c));
  if (!(c_side * d_side < 0 && a_side * b_side < 0))
    return false;
  place = c + c_side / (c_side - d_side) * (d - c);
  return true;
}

double
cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

double
signedArea(const Loop& loop)
{
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    twice += cross(Eigen::Vector2d(loop[i] - loop[0]),
                   Eigen::Vector2d(loop[(i + 1) % loop.size()] - loop[0]));
  return twice / 2;
}

bool
contains(const Loop& loop, const Eigen::Vector2d& point)
{
  bool is_inside = false;
  for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
    const Eigen::Vector2d &a = loop[i], &b = loop[j];
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()))
      is_inside = !is_inside;
  }
  return is_inside;
}

Nesting
nestingOf(const std::vector<Loop>& loops, double min_area)
{
  Nesting nesting;
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (signedArea(loops[i]) >= min_area)
      nesting.rims.push_back(i);
  std::stable_sort(
      nesting.rims.begin(), nesting.rims.end(), [&](std::size_t a, std::size_t b) {
        return signedArea(loops[a]) > signedArea(loops[b]);
      });
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (loops[i].size() < 3 || signedArea(loops[i]) > -min_area)
      continue;
    // The middle of an edge is tested, because vertices may touch the rim.
    const Eigen::Vector2d middle = (loops[i][0] + loops[i][1]) / 2;
    for (std::size_t r = nesting.rims.size(); r-- > 0;)
      if (contains(loops[nesting.rims[r]], middle)) {
        nesting.holes.emplace_back(i, r);
        break;
      }
  }
  return nesting;
}

Loop
simplified(const Loop& loop, double tolerance)
{
  if (loop.size() < 4)
    return loop;
  // The loop is split at a point that is surely a corner and at the point farthest from
  // it.
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : loop)
    middle += point / static_cast<double>(loop.size());
  Loop turned = loop;
  std::rotate(turned.begin(),
              turned.begin() + static_cast<std::ptrdiff_t>(farthestFrom(loop, middle)),
              turned.end());
  const std::size_t opposite = farthestFrom(turned, turned[0]);
  std::vector<std::uint8_t> is_kept(turned.size(), 0);
  is_kept[0] = is_kept[opposite] = 1;
  markKept(turned, 0, opposite, tolerance, is_kept);
  markKept(turned, opposite, turned.size(), tolerance, is_kept);
  Loop kept;
  for (std::size_t i = 0; i < turned.size(); ++i)
    if (is_kept[i])
      kept.push_back(turned[i]);
  return kept;
}

Loop
uncrossed(Loop loop)
{
  for (std::size_t i = 0; i + 1 < loop.size();) {
    Eigen::Vector2d place;
    const std::size_t j = firstCrossing(loop, i, place);
    if (j == 0) {
      ++i;
      continue;
    }
    const auto first = loop.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    const auto last = loop.begin() + static_cast<std::ptrdiff_t>(j) + 1;
    Loop inner(first, last);
    inner.push_back(place);
    Loop outer(loop.begin(), first);
    outer.push_back(place);
    outer.insert(outer.end(), last, loop.end());
    const bool keeps_outer = std::abs(signedArea(outer)) >= std::abs(signedArea(inner));
    loop = std::move(keeps_outer ? outer : inner);
    i = keeps_outer ? i : 0;
  }
  return loop;
}

} // namespace pcl::acmap::outlines
