#include "naming/smallest_rectangle.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;

bool
turnsLeft(const Vector2d& a, const Vector2d& b, const Vector2d& c)
{
  return (b - a).x() * (c - b).y() - (b - a).y() * (c - b).x() > 0;
}

/** \brief One half of the convex hull of sorted points (Andrew's monotone chain). */
template <typename Iterator>
std::vector<Vector2d>
chainOf(Iterator begin, Iterator end)
{
  std::vector<Vector2d> chain;
  for (; begin != end; ++begin) {
    while (chain.size() >= 2 &&
           !turnsLeft(chain[chain.size() - 2], chain.back(), *begin))
      chain.pop_back();
    chain.push_back(*begin);
  }
  return chain;
}

} // namespace

Vector2d
sidesOfSmallestRectangle(std::vector<Vector2d> points)
{
  if (points.empty())
    return Vector2d::Zero();
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<Vector2d> hull = chainOf(points.begin(), points.end());
  const std::vector<Vector2d> upper = chainOf(points.rbegin(), points.rend());
  hull.insert(hull.end(), upper.begin(), upper.end());
  Vector2d smallest = Vector2d::Constant(std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Vector2d edge = hull[(k + 1) % hull.size()] - hull[k];
    // a side of the smallest rectangle lies on an edge of the hull
    const Vector2d along = edge.norm() > 0 ? edge.normalized() : Vector2d::UnitX();
    Eigen::AlignedBox2d box;
    for (const Vector2d& corner : hull)
      box.extend(
          Vector2d(corner.dot(along), corner.dot(Vector2d(-along.y(), along.x()))));
    if (box.sizes().prod() < smallest.prod() ||
        (box.sizes().prod() == smallest.prod() && box.sizes().sum() < smallest.sum()))
      smallest = box.sizes();
  }
  return {smallest.maxCoeff(), smallest.minCoeff()};
}

} // namespace pcl::acmap
