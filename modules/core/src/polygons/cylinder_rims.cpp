#include <pcl/core/cylinder_rims.h>

#include "polygons/boundary.h"
#include "polygons/cylinder_seams.h"

#include <pcl/core/cylinder_facets.h>
#include <pcl/core/impl/arguments.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl {

namespace {

using acmap::Boundary;
using Eigen::Vector3d;

/** The intersection of a plane with a cylinder. */
class Rim {
public:
  /** \param[in] number of the cylinder
   * \param[in] facets number of its facets */
  Rim(const CylinderPatch& cylinder,
      std::size_t number,
      std::size_t facets,
      const PlanePatch& plane,
      double tolerance)
  : cylinder_(cylinder)
  , number_(static_cast<std::int32_t>(number))
  , plane_(plane.coefficients)
  , slope_(plane_.head<3>().dot(cylinder.axis_direction))
  , tolerance_(std::min(tolerance, cylinder.radius / 2))
  , facets_(facets)
  {
    constexpr double min_slope = 0.2; // sine of 12 degrees
    exists_ = facets_ > 0 && cylinder.high > cylinder.low && plane_.allFinite() &&
              std::abs(slope_) > min_slope;
  }

  bool
  exists() const
  {
    return exists_;
  }

  /** Replaces what runs along the rim. \return number of arcs */
  std::size_t
  join(Boundary& boundary) const;

  /** Position along the axis at which the axis meets the plane; nothing if not at a right
   * angle. */
  std::optional<double>
  end() const
  {
    constexpr double right = 0.996; // cosine of 5 degrees
    if (std::abs(slope_) < right)
      return {};
    return -(plane_.head<3>().dot(cylinder_.axis_point) + plane_[3]) / slope_;
  }

private:
  Vector3d
  wayTo(const Eigen::Vector3f& point) const
  {
    return point.cast<double>() - cylinder_.axis_point;
  }

  double
  angleOf(const Eigen::Vector3f& point) const
  {
    const Vector3d way = wayTo(point);
    return std::atan2(way.dot(cylinder_.axis_v), way.dot(cylinder_.axis_u));
  }

  Eigen::Vector3f
  pointAt(double angle) const
  {
    const Vector3d across =
        cylinder_.axis_point + cylinder_.radius * (std::cos(angle) * cylinder_.axis_u +
                                                   std::sin(angle) * cylinder_.axis_v);
    const double along = -(plane_.head<3>().dot(across) + plane_[3]) / slope_;
    return (across + along * cylinder_.axis_direction).cast<float>();
  }

  bool
  isNear(const Eigen::Vector3f& point) const
  {
    constexpr double reach = 3; // tolerances beyond an end of the cylinder
    const Vector3d way = wayTo(point);
    const double along = way.dot(cylinder_.axis_direction);
    const double radius = (way - along * cylinder_.axis_direction).norm();
    return std::abs(radius - cylinder_.radius) < tolerance_ &&
           along > cylinder_.low - reach * tolerance_ &&
           along < cylinder_.high + reach * tolerance_ &&
           std::abs(angleOf(point)) <
               cylinder_.arc / 2 + 2 * tolerance_ / cylinder_.radius;
  }

  /** Turn from one point to the next, within half a turn. */
  double
  turnOf(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const
  {
    return std::remainder(angleOf(to) - angleOf(from), 2 * M_PI);
  }

  /** Is a point part of an edge that other planes, or other cylinders, have too? */
  static bool
  isFixed(const Boundary& boundary, std::size_t point)
  {
    const std::size_t size = boundary.edges.size();
    const auto isTaken = [](const PolygonEdge& edge) {
      return acmap::isShared(edge) || edge.kind == EdgeKind::Arc;
    };
    return isTaken(boundary.edges[point]) ||
           isTaken(boundary.edges[(point + size - 1) % size]);
  }

  bool
  isOn(const Eigen::Vector3f& point) const
  {
    constexpr float rounding = 1e-4F; // metres
    return isNear(point) && (pointAt(angleOf(point)) - point).norm() < rounding;
  }

  /** For each edge of a boundary: does it run along the rim, and may it be moved? */
  std::vector<bool>
  edgesOnRim(const Boundary& boundary) const;

  Boundary
  arcOf(double begin, double turn) const;

  const CylinderPatch& cylinder_;
  std::int32_t number_;
  Eigen::Vector4d plane_;
  double slope_;
  double tolerance_;
  std::size_t facets_;
  bool exists_ = false;
};

std::vector<bool>
Rim::edgesOnRim(const Boundary& boundary) const
{
  constexpr double max_turn = M_PI / 2; // of one edge: longer ones cut through
  const std::size_t size = boundary.points.size();
  std::vector<bool> may_join(size), is_on(size);
  for (std::size_t i = 0; i < size; ++i)
    may_join[i] =
        isFixed(boundary, i) ? isOn(boundary.points[i]) : isNear(boundary.points[i]);
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t next = (i + 1) % size;
    is_on[i] = may_join[i] && may_join[next] && !acmap::isShared(boundary.edges[i]) &&
               boundary.edges[i].kind != EdgeKind::Arc &&
               std::abs(turnOf(boundary.points[i], boundary.points[next])) < max_turn;
  }
  return is_on;
}

/** Points of the rim from an angle on, at the directions of the facets, and the last
 * one. */
Boundary
Rim::arcOf(double begin, double turn) const
{
  const double step = cylinder_.arc / static_cast<double>(facets_);
  const double first = -cylinder_.arc / 2; // direction of the first facet
  const double sign = turn < 0 ? -1 : 1;
  const double slack = step / 10; // shorter edges are left out
  Boundary arc;
  const auto append = [&](double angle) {
    arc.points.push_back(pointAt(angle));
    arc.edges.push_back({EdgeKind::Arc, number_});
  };
  append(begin);
  const double at = (begin - first) / step * sign;
  for (double k = std::ceil(at); (k - at) * step < std::abs(turn) - slack; ++k)
    if ((k - at) * step > slack)
      append(first + sign * k * step);
  if (std::abs(turn) < 2 * M_PI - slack)
    append(begin + turn);
  return arc;
}

std::size_t
Rim::join(Boundary& boundary) const
{
  constexpr double min_turn = M_PI / 9; // 20 degrees
  const std::vector<bool> is_on = edgesOnRim(boundary);
  const std::size_t size = is_on.size();
  const auto off = std::find(is_on.begin(), is_on.end(), false);
  const bool is_closed = off == is_on.end();
  const std::size_t start =
      is_closed ? 0 : static_cast<std::size_t>(off - is_on.begin() + 1);
  Boundary joined;
  std::size_t arcs = 0;
  for (std::size_t step = 0; step < size;) {
    const std::size_t first = (start + step) % size;
    double turn = 0;
    std::size_t count = 0;
    while (count < size - step && is_on[(first + count) % size]) {
      turn += turnOf(boundary.points[(first + count) % size],
                     boundary.points[(first + count + 1) % size]);
      ++count;
    }
    if (std::abs(turn) < min_turn) {
      for (std::size_t k = 0; k <= std::min(count, size - step - 1); ++k) {
        joined.points.push_back(boundary.points[(first + k) % size]);
        joined.edges.push_back(boundary.edges[(first + k) % size]);
      }
      step += count + 1;
      continue;
    }
    const std::size_t last = (first + count) % size;
    Boundary arc =
        arcOf(is_closed ? -cylinder_.arc / 2 : angleOf(boundary.points[first]), turn);
    if (!is_closed && isFixed(boundary, first))
      arc.points.front() = boundary.points[first];
    if (!is_closed && isFixed(boundary, last))
      arc.points.back() = boundary.points[last];
    joined.points.insert(joined.points.end(), arc.points.begin(), arc.points.end());
    joined.edges.insert(joined.edges.end(), arc.edges.begin(), arc.edges.end());
    if (!is_closed) // the last point is followed by an edge that stays
      joined.edges.back() = boundary.edges[last];
    step += count + 1;
    ++arcs;
  }
  if (arcs > 0)
    boundary = std::move(joined);
  return arcs;
}

/** Joins the polygons of one plane to one cylinder. \return number of arcs */
std::size_t
joinPlane(const Rim& rim, PlanePatch& plane)
{
  const Vector3d normal = plane.coefficients.head<3>();
  std::size_t arcs = 0;
  for (PlanePolygon& polygon : plane.polygons) {
    const std::vector<acmap::Boundary> before = acmap::boundariesOf(polygon);
    std::vector<acmap::Boundary> after = before;
    std::size_t found = 0;
    for (Boundary& boundary : after)
      if (boundary.points.size() >= 3)
        found += rim.join(boundary);
    if (found == 0 || !acmap::mayReplace(before, after, plane))
      continue;
    plane.area += acmap::areaOf(after, normal) - acmap::areaOf(before, normal);
    polygon = acmap::polygonOf(after);
    arcs += found;
  }
  return arcs;
}

} // namespace

std::size_t
joinAtCylinders(double tolerance,
                std::vector<CylinderPatch>& cylinders,
                std::vector<PlanePatch>& planes)
{
  acmap::requireInRange("tolerance", tolerance, 0, 1e9, "m");
  constexpr double reach = 3; // tolerances between the end of a cylinder and a plane
  std::size_t arcs = 0;
  for (std::size_t c = 0; c < cylinders.size(); ++c)
    arcs += acmap::joinAlongAxis(tolerance, c, cylinders[c], planes);
  for (std::size_t c = 0; c < cylinders.size(); ++c) {
    CylinderPatch& cylinder = cylinders[c];
    const std::size_t facets = facetsOfCylinder(cylinder).size();
    for (PlanePatch& plane : planes) {
      const Rim rim(cylinder, c, facets, plane, tolerance);
      const std::size_t found = rim.exists() ? joinPlane(rim, plane) : 0;
      arcs += found;
      const std::optional<double> end = rim.end();
      if (found == 0 || !end)
        continue;
      for (double* const side : {&cylinder.low, &cylinder.high})
        if (std::abs(*end - *side) < reach * tolerance)
          *side = *end;
      cylinder.area = cylinder.arc * cylinder.radius * (cylinder.high - cylinder.low);
    }
  }
  return arcs;
}

} // namespace pcl
