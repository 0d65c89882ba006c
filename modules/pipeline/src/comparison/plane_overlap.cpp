#include "comparison/plane_overlap.h"

#include <pcl/core/impl/planar_geometry.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
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

/** \brief Squares of a rectangle of a true plane, and which of them planes cover. */
class CoveredSquares {
public:
  /** \param[in] box of all that will be added, texels
   * \param[in] side of a square, texels */
  CoveredSquares(const Eigen::AlignedBox2d& box, double side)
  : low_(box.min())
  , side_(side)
  , columns_(squaresOf(box.sizes().x()))
  , rows_(squaresOf(box.sizes().y()))
  , windings_((columns_ + 1) * rows_)
  , is_covered_(columns_ * rows_)
  {}

  /** \param[in] polygon convex */
  void
  add(const Polygon& polygon)
  {
    double doubled = 0, low = polygon[0].place.y(), high = low;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector2d& place = polygon[i].place;
      low = std::min(low, place.y());
      high = std::max(high, place.y());
      doubled += crossOf(place - polygon[0].place,
                         polygon[(i + 1) % polygon.size()].place - polygon[0].place);
    }
    const int winding = doubled > 0 ? 1 : -1;
    const std::size_t end = firstMiddle(high - low_.y(), rows_);
    for (std::size_t row = firstMiddle(low - low_.y(), rows_); row < end; ++row) {
      const auto [left, right] = cutOf(polygon, middleOf(row) + low_.y());
      windings_[row * (columns_ + 1) + firstMiddle(left - low_.x(), columns_)] +=
          winding;
      windings_[row * (columns_ + 1) + firstMiddle(right - low_.x(), columns_)] -=
          winding;
    }
  }

  /** \brief What was added since the last call is one plane. */
  void
  finishPlane()
  {
    for (std::size_t row = 0; row < rows_; ++row) {
      int winding = 0;
      for (std::size_t column = 0; column < columns_; ++column) {
        winding += windings_[row * (columns_ + 1) + column];
        if (winding != 0)
          is_covered_[row * columns_ + column] = true;
      }
    }
    std::fill(windings_.begin(), windings_.end(), 0);
  }

  std::size_t
  count() const
  {
    return static_cast<std::size_t>(
        std::count(is_covered_.begin(), is_covered_.end(), true));
  }

private:
  std::size_t
  squaresOf(double texels) const
  {
    return static_cast<std::size_t>(std::ceil(texels / side_)) + 1;
  }

  double
  middleOf(std::size_t square) const
  {
    return side_ * (static_cast<double>(square) + 0.5);
  }

  /** \brief The first square of which the middle is at or behind a place. */
  std::size_t
  firstMiddle(double texels, std::size_t end) const
  {
    const double square = std::ceil(texels / side_ - 0.5);
    return static_cast<std::size_t>(std::clamp(square, 0.0, static_cast<double>(end)));
  }

  /** \brief From where to where a row cuts a polygon. */
  static std::pair<double, double>
  cutOf(const Polygon& polygon, double y)
  {
    constexpr double far = std::numeric_limits<double>::max();
    double left = far, right = -far;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector2d& from = polygon[i].place;
      const Eigen::Vector2d& to = polygon[(i + 1) % polygon.size()].place;
      if ((from.y() < y) == (to.y() < y))
        continue;
      const double x =
          from.x() + (y - from.y()) / (to.y() - from.y()) * (to.x() - from.x());
      left = std::min(left, x);
      right = std::max(right, x);
    }
    return left <= right ? std::pair(left, right) : std::pair(0.0, 0.0);
  }

  Eigen::Vector2d low_;
  double side_;
  std::size_t columns_, rows_;
  std::vector<int> windings_; ///< of the plane that is added: changes along each row
  std::vector<bool> is_covered_;
};

/** \brief A plane of the map, cut to a rectangle of a true plane. */
std::vector<Polygon>
clippedTo(const ChartClip& rectangle, const PlacedPlane& plane)
{
  std::vector<Polygon> polygons;
  for (const auto& triangle : plane.fans)
    if (Polygon polygon = rectangle.clipped(triangle); polygon.size() > 2)
      polygons.push_back(std::move(polygon));
  return polygons;
}

/** \brief Extent and scale of what is on a rectangle. */
struct Extent {
  Eigen::AlignedBox2d box; ///< texels
  double texel = 0;        ///< metres of its side; 0 if nothing has an area
};

/** \brief The scale is that of all polygons together, since slivers tell it badly. */
Extent
extentOf(const std::vector<std::vector<Polygon>>& planes)
{
  Extent extent;
  double places = 0, points = 0;
  for (const std::vector<Polygon>& polygons : planes)
    for (const Polygon& polygon : polygons)
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        extent.box.extend(polygon[i].place);
        if (i < 2)
          continue;
        places += std::abs(crossOf(polygon[i - 1].place - polygon[0].place,
                                   polygon[i].place - polygon[0].place));
        points += (polygon[i - 1].point - polygon[0].point)
                      .cross(polygon[i].point - polygon[0].point)
                      .norm();
      }
  if (places > 0)
    extent.texel = std::sqrt(points / places);
  return extent;
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
  constexpr double finest = 0.02, max_squares = 4e6; // metres; of a rectangle
  double area = 0;
  for (const ChartClip& rectangle : truth.rectangles) {
    std::vector<std::vector<Polygon>> planes;
    for (const PlacedPlane& plane : found)
      planes.push_back(clippedTo(rectangle, plane));
    const Extent extent = extentOf(planes);
    if (extent.texel == 0)
      continue;
    const double square =
        std::max(finest, extent.texel * std::sqrt(extent.box.volume() / max_squares));
    CoveredSquares squares(extent.box, square / extent.texel);
    for (const std::vector<Polygon>& polygons : planes) {
      for (const Polygon& polygon : polygons)
        squares.add(polygon);
      squares.finishPlane();
    }
    area += square * square * static_cast<double>(squares.count());
  }
  return area;
}

} // namespace pcl::acmap
