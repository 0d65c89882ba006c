#include "polygons/cylinder_seams.h"

#include "polygons/boundary.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace pcl::acmap {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

/** A line along the axis in which a plane and a cylinder meet. */
struct Seam {
  double angle = 0;     ///< from axis_u
  bool is_high = false; ///< at the end of the arc with the larger angle
  Vector3d point = Vector3d::Zero();
  Vector3d direction = Vector3d::UnitZ(); ///< of the axis

  double
  along(const Vector3d& place) const
  {
    return (place - point).dot(direction);
  }

  double
  distance(const Vector3d& place) const
  {
    return (place - point - along(place) * direction).norm();
  }
};

/** The lines in which a plane and a cylinder meet near the ends of its arc. */
std::vector<Seam>
seamsOf(const CylinderPatch& cylinder, const PlanePatch& plane, double tolerance)
{
  constexpr double parallel = 0.05; // sine of 3 degrees
  const Vector3d normal = plane.coefficients.head<3>();
  const double across = normal.dot(cylinder.axis_u), up = normal.dot(cylinder.axis_v);
  const double off = normal.dot(cylinder.axis_point) + plane.coefficients[3];
  const double cosine = -off / (cylinder.radius * std::hypot(across, up));
  if (!(std::abs(normal.dot(cylinder.axis_direction)) < parallel) ||
      !(std::abs(cosine) < 1))
    return {};
  std::vector<Seam> seams;
  for (const double side : {-1.0, 1.0}) {
    const double angle =
        std::remainder(std::atan2(up, across) + side * std::acos(cosine), 2 * M_PI);
    if (std::abs(std::abs(angle) - cylinder.arc / 2) * cylinder.radius > tolerance)
      continue;
    const Vector3d direction =
        std::cos(angle) * cylinder.axis_u + std::sin(angle) * cylinder.axis_v;
    seams.push_back({angle,
                     angle > 0,
                     cylinder.axis_point + cylinder.radius * direction,
                     cylinder.axis_direction});
  }
  return seams;
}

using Key = std::array<float, 3>;
using Moves = std::map<Key, Vector3f>;

Key
keyOf(const Vector3f& point)
{
  return {point.x(), point.y(), point.z()};
}

/** Finds where the points of a boundary go that run along a seam. */
class SeamWalk {
public:
  SeamWalk(const Seam& seam,
           const CylinderPatch& cylinder,
           const std::vector<PlanePatch>& planes,
           double tolerance)
  : seam_(seam)
  , cylinder_(cylinder)
  , planes_(planes)
  , tolerance_(tolerance)
  {}

  /** Adds the moves of the points of edges along the seam, which become edges at the
   * cylinder.
   * \return is there any? */
  bool
  walk(std::int32_t number, Boundary& boundary, Moves& moves) const
  {
    bool has_edge = false;
    const std::size_t size = boundary.points.size();
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t next = (i + 1) % size;
      if (isShared(boundary.edges[i]) || boundary.edges[i].kind == EdgeKind::Arc ||
          !isAlong(boundary.points[i], boundary.points[next]))
        continue;
      const std::optional<Vector3f> from =
          placeOf(boundary.points[i], boundary.edges[(i + size - 1) % size]);
      const std::optional<Vector3f> to =
          placeOf(boundary.points[next], boundary.edges[next]);
      if (!from || !to)
        continue;
      moves[keyOf(boundary.points[i])] = *from;
      moves[keyOf(boundary.points[next])] = *to;
      boundary.edges[i] = {EdgeKind::Arc, number};
      has_edge = true;
    }
    return has_edge;
  }

private:
  bool
  isNear(const Vector3d& place) const
  {
    constexpr double reach = 3; // tolerances beyond an end of the cylinder
    const double along = seam_.along(place);
    return seam_.distance(place) < tolerance_ &&
           along > cylinder_.low - reach * tolerance_ &&
           along < cylinder_.high + reach * tolerance_;
  }

  bool
  isAlong(const Vector3f& from, const Vector3f& to) const
  {
    constexpr double min_cosine = 0.95; // 18 degrees
    const Vector3d a = from.cast<double>(), b = to.cast<double>();
    const double length = std::abs(seam_.along(b) - seam_.along(a));
    return isNear(a) && isNear(b) && length > 2 * tolerance_ &&
           length > min_cosine * (b - a).norm();
  }

  /** Where a point goes: on the seam, and on the other plane of an edge that ends in it.
   * Nothing if that is far away. */
  std::optional<Vector3f>
  placeOf(const Vector3f& point, const PolygonEdge& edge) const
  {
    const Vector3d place = point.cast<double>();
    double along = seam_.along(place);
    if (isShared(edge)) {
      if (edge.neighbour < 0 ||
          static_cast<std::size_t>(edge.neighbour) >= planes_.size())
        return {};
      const Eigen::Vector4d& other =
          planes_[static_cast<std::size_t>(edge.neighbour)].coefficients;
      along = -(other.head<3>().dot(seam_.point) + other[3]) /
              other.head<3>().dot(seam_.direction);
    }
    const Vector3d moved = seam_.point + along * seam_.direction;
    if (!((moved - place).norm() < 2 * tolerance_)) // true for NaN
      return {};
    return moved.cast<float>();
  }

  const Seam& seam_;
  const CylinderPatch& cylinder_;
  const std::vector<PlanePatch>& planes_;
  double tolerance_;
};

/** Moves points in all polygons that have them.
 * \return false if a polygon does not permit that; planes are then not changed */
bool
moveAll(const Moves& moves, std::vector<PlanePatch>& planes)
{
  std::vector<PlanePatch> moved = planes;
  for (PlanePatch& plane : moved) {
    const Vector3d normal = plane.coefficients.head<3>();
    for (PlanePolygon& polygon : plane.polygons) {
      const std::vector<Boundary> before = boundariesOf(polygon);
      std::vector<Boundary> after = before;
      bool is_changed = false;
      for (Boundary& boundary : after)
        for (Vector3f& point : boundary.points)
          if (const auto move = moves.find(keyOf(point)); move != moves.end()) {
            point = move->second;
            is_changed = true;
          }
      if (!is_changed)
        continue;
      if (!mayReplace(before, after, plane))
        return false;
      plane.area += areaOf(after, normal) - areaOf(before, normal);
      const bool tells_edges = !polygon.edges.empty();
      polygon = polygonOf(after);
      if (!tells_edges)
        polygon.edges.clear();
    }
  }
  planes = std::move(moved);
  return true;
}

/** Lets the arc of a cylinder end at a seam. */
void
endAt(const Seam& seam, CylinderPatch& cylinder)
{
  const double begin = seam.is_high ? -cylinder.arc / 2 : seam.angle;
  const double end = seam.is_high ? seam.angle : cylinder.arc / 2;
  const double turn = (begin + end) / 2, cosine = std::cos(turn), sine = std::sin(turn);
  const Vector3d u = cylinder.axis_u, v = cylinder.axis_v;
  cylinder.axis_u = cosine * u + sine * v;
  cylinder.axis_v = cosine * v - sine * u;
  cylinder.area *= (end - begin) / cylinder.arc;
  cylinder.arc = end - begin;
  Eigen::Matrix<double, 5, 5> change = Eigen::Matrix<double, 5, 5>::Identity();
  for (const Eigen::Index first : {0, 2})
    change.block<2, 2>(first, first) << cosine, sine, -sine, cosine;
  cylinder.covariance = change * cylinder.covariance * change.transpose();
}

/** Joins a cylinder to one plane at a seam.
 * \param[in] p number of the plane */
bool
joinAt(const Seam& seam,
       double tolerance,
       std::size_t number,
       std::size_t p,
       CylinderPatch& cylinder,
       std::vector<PlanePatch>& planes)
{
  PlanePatch plane = planes[p];
  Moves moves;
  const SeamWalk walk(seam, cylinder, planes, tolerance);
  for (PlanePolygon& polygon : plane.polygons) {
    std::vector<Boundary> boundaries = boundariesOf(polygon);
    bool has_edge = false;
    for (Boundary& boundary : boundaries)
      has_edge |= walk.walk(static_cast<std::int32_t>(number), boundary, moves);
    if (has_edge)
      polygon = polygonOf(boundaries);
  }
  if (moves.empty())
    return false;
  std::swap(planes[p], plane);
  if (!moveAll(moves, planes)) {
    std::swap(planes[p], plane);
    return false;
  }
  endAt(seam, cylinder);
  return true;
}

} // namespace

std::size_t
joinAlongAxis(double tolerance,
              std::size_t number,
              CylinderPatch& cylinder,
              std::vector<PlanePatch>& planes)
{
  constexpr double closed = 2 * M_PI - 0.2; // an arc without ends
  std::size_t lines = 0;
  if (!(cylinder.radius > 0) || !(cylinder.arc > 0 && cylinder.arc < closed))
    return 0;
  for (std::size_t p = 0; p < planes.size(); ++p)
    for (const bool is_high : {false, true}) // the arc of the first changes the second
      for (const Seam& seam : seamsOf(cylinder, planes[p], tolerance))
        if (seam.is_high == is_high &&
            joinAt(seam, tolerance, number, p, cylinder, planes))
          ++lines;
  return lines;
}

} // namespace pcl::acmap
