#include "comparison/plane_overlap.h"

#include <pcl/core/impl/planar_geometry.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace pcl::acmap {

namespace {

/** \brief Signed area of a triangle; negative if it is clockwise seen from the side of
 * the normal. */
double
areaOf(const Eigen::Vector3d& a,
       const Eigen::Vector3d& b,
       const Eigen::Vector3d& c,
       const Eigen::Vector3d& normal)
{
  return (b - a).cross(c - a).dot(normal) / 2;
}

/** \brief Adds a convex polygon; `middle` is a weighted sum until all polygons are
 * added. */
void
add(const std::vector<ChartCorner>& polygon,
    const Eigen::Vector3d& normal,
    PlaneOverlap& overlap)
{
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Eigen::Vector3d& a = polygon[0].point;
    const Eigen::Vector3d& b = polygon[i - 1].point;
    const Eigen::Vector3d& c = polygon[i].point;
    const double area = areaOf(a, b, c, normal);
    overlap.area += area;
    overlap.middle += area * (a + b + c) / 3;
  }
}

void
addFan(const std::vector<Eigen::Vector3f>& loop,
       const Eigen::Isometry3d& T_truth_map,
       PlacedPlane& plane)
{
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& point : loop)
    points.push_back(T_truth_map * point.cast<double>());
  for (std::size_t i = 2; i < points.size(); ++i) {
    plane.fans.push_back({points[0], points[i - 1], points[i]});
    plane.area +=
        areaOf(points[0], points[i - 1], points[i], plane.coefficients.head<3>());
  }
}

using Polygon = std::vector<ChartCorner>;

/** \brief Squares of a rectangle of a true plane, and what covers them. */
class CoveredSquares {
public:
  /** \param[in] polygon convex, with an area */
  void
  add(const Polygon& polygon)
  {
    Eigen::Vector2d low = polygon[0].place, high = low;
    double doubled = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector2d& place = polygon[i].place;
      low = low.cwiseMin(place);
      high = high.cwiseMax(place);
      doubled += crossOf(place, polygon[(i + 1) % polygon.size()].place);
    }
    for (auto row = squareAt(low.y()); row <= squareAt(high.y()); ++row)
      for (auto column = squareAt(low.x()); column <= squareAt(high.x()); ++column)
        if (hasMiddle(polygon, doubled, column, row))
          windings_[{column, row}] += doubled > 0 ? 1 : -1;
  }

  /** \brief What was added since the last call is one plane. */
  void
  finishPlane()
  {
    for (const auto& [square, winding] : windings_)
      if (winding != 0)
        covered_.insert(square);
    windings_.clear();
  }

  std::size_t
  count() const
  {
    return covered_.size();
  }

  double side = 1; ///< of a square, texels

private:
  std::int64_t
  squareAt(double texel) const
  {
    return static_cast<std::int64_t>(std::floor(texel / side));
  }

  bool
  hasMiddle(const Polygon& polygon,
            double doubled,
            std::int64_t column,
            std::int64_t row) const
  {
    const Eigen::Vector2d middle =
        side * Eigen::Vector2d(static_cast<double>(column) + 0.5,
                               static_cast<double>(row) + 0.5);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector2d& from = polygon[i].place;
      const Eigen::Vector2d& to = polygon[(i + 1) % polygon.size()].place;
      if (crossOf(to - from, middle - from) * doubled < 0)
        return false;
    }
    return true;
  }

  using Square = std::pair<std::int64_t, std::int64_t>;

  std::map<Square, int> windings_; ///< of the plane that is added
  std::set<Square> covered_;
};

/** \brief Metres of a texel's side, by a polygon; 0 if that has no area. */
double
texelSide(const Polygon& polygon)
{
  double places = 0;
  Eigen::Vector3d points = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    places += crossOf(polygon[i - 1].place - polygon[0].place,
                      polygon[i].place - polygon[0].place);
    points += (polygon[i - 1].point - polygon[0].point)
                  .cross(polygon[i].point - polygon[0].point);
  }
  return places == 0 ? 0 : std::sqrt(points.norm() / std::abs(places));
}

} // namespace

PlacedPlane
placed(const PlanePatch& plane, const Eigen::Isometry3d& T_truth_map)
{
  PlacedPlane result;
  const Eigen::Vector3d normal = T_truth_map.linear() * plane.coefficients.head<3>();
  const double offset = plane.coefficients[3] - normal.dot(T_truth_map.translation());
  result.coefficients << normal, offset;
  for (const PlanePolygon& polygon : plane.polygons) {
    addFan(polygon.outer, T_truth_map, result);
    for (const auto& hole : polygon.holes)
      addFan(hole, T_truth_map, result);
  }
  return result;
}

PlaneOverlap
overlapOf(const PlacedPlane& found, const TruePlane& truth)
{
  PlaneOverlap overlap;
  for (const ChartClip& rectangle : truth.rectangles)
    for (const auto& triangle : found.fans)
      add(rectangle.clipped(triangle), found.coefficients.head<3>(), overlap);
  if (overlap.area > 0)
    overlap.middle /= overlap.area;
  return overlap;
}

double
coverOf(const std::vector<PlacedPlane>& found, const TruePlane& truth)
{
  constexpr double square = 0.02; // metres
  double area = 0;
  for (const ChartClip& rectangle : truth.rectangles) {
    CoveredSquares squares;
    bool has_side = false;
    for (const PlacedPlane& plane : found) {
      for (const auto& triangle : plane.fans) {
        const Polygon polygon = rectangle.clipped(triangle);
        const double side = texelSide(polygon);
        if (side == 0)
          continue;
        if (!has_side)
          squares.side = square / side;
        has_side = true;
        squares.add(polygon);
      }
      squares.finishPlane();
    }
    area += square * square * static_cast<double>(squares.count());
  }
  return area;
}

} // namespace pcl::acmap
