#include "polygon_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

double
cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** Do the segments ab and cd cross? Touching does not count. */
bool
doCross(const Eigen::Vector2d& a,
        const Eigen::Vector2d& b,
        const Eigen::Vector2d& c,
        const Eigen::Vector2d& d)
{
  constexpr double touch = 1e-9; // square metres: vertices are rounded to float
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  return std::min(c_side, d_side) < -touch && std::max(c_side, d_side) > touch &&
         std::min(a_side, b_side) < -touch && std::max(a_side, b_side) > touch;
}

} // namespace

FlatLoop
flattened(const PlanePatch& patch, const std::vector<Eigen::Vector3f>& loop)
{
  FlatLoop flat;
  for (const Eigen::Vector3f& point : loop) {
    const Eigen::Vector3d way = point.cast<double>() - patch.center;
    flat.emplace_back(way.dot(patch.axis_u), way.dot(patch.axis_v));
  }
  return flat;
}

double
areaOf(const FlatLoop& loop)
{
  double twice = 0;
  for (std::size_t i = 0; i + 1 < loop.size(); ++i)
    twice += cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
  return twice / 2;
}

bool
isInside(const FlatLoop& loop, const Eigen::Vector2d& place)
{
  double turned = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d a = loop[i] - place, b = loop[(i + 1) % loop.size()] - place;
    turned += std::atan2(cross(a, b), a.dot(b));
  }
  return std::abs(turned) > M_PI;
}

std::size_t
countCrossings(const FlatLoop& loop)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    for (std::size_t j = i + 2; j < loop.size(); ++j)
      count += doCross(loop[i], loop[i + 1], loop[j], loop[(j + 1) % loop.size()]);
  return count;
}

std::size_t
countCrossings(const FlatLoop& a, const FlatLoop& b)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      count += doCross(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()]);
  return count;
}

double
distanceToLine(const FlatLoop& loop, const Eigen::Vector2d& place)
{
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d way = loop[(i + 1) % loop.size()] - loop[i];
    const double along =
        std::clamp((place - loop[i]).dot(way) / way.squaredNorm(), 0.0, 1.0);
    minimum = std::min(minimum, (loop[i] + along * way - place).norm());
  }
  return minimum;
}

void
expectSound(const PlanePatch& patch)
{
  double area = 0;
  for (const PlanePolygon& polygon : patch.polygons) {
    const FlatLoop outer = flattened(patch, polygon.outer);
    EXPECT_GE(outer.size(), 3U);
    EXPECT_GT(areaOf(outer), 0) << "counter-clockwise";
    EXPECT_EQ(countCrossings(outer), 0U);
    area += areaOf(outer);
    for (const auto& points : polygon.holes) {
      const FlatLoop hole = flattened(patch, points);
      EXPECT_GE(hole.size(), 3U);
      EXPECT_LT(areaOf(hole), 0) << "clockwise";
      EXPECT_EQ(countCrossings(hole), 0U);
      EXPECT_EQ(countCrossings(hole, outer), 0U);
      EXPECT_TRUE(isInside(outer, hole[0]));
      area += areaOf(hole);
    }
    for (const Eigen::Vector3f& point : polygon.outer)
      EXPECT_NEAR(patch.coefficients.head<3>().dot(point.cast<double>()) +
                      patch.coefficients[3],
                  0,
                  1e-5);
  }
  EXPECT_NEAR(patch.area, area, 1e-4 * area + 1e-9);
}

} // namespace pcl::acmap::test
