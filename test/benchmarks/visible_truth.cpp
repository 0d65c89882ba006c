#include "outline_scores.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace pcl::acmap::bench {
namespace {

constexpr double min_sine = 0.17; ///< of the angle between faces that form a crease

/** \brief Fraction of a segment after which it hits a surface; infinite for none. */
class Hit {
public:
  Hit(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
  : from_(from)
  , along_(to - from)
  {}

  double
  operator()(const SimulatedRectangle& shape) const
  {
    const Eigen::Vector3d normal = shape.edge_u.cross(shape.edge_v);
    const double part = normal.dot(shape.corner - from_) / normal.dot(along_);
    const Eigen::Vector3d place = from_ + part * along_ - shape.corner;
    const double u = place.dot(shape.edge_u) / shape.edge_u.squaredNorm();
    const double v = place.dot(shape.edge_v) / shape.edge_v.squaredNorm();
    const bool is_inside =
        u >= -slack && u <= 1 + slack && v >= -slack && v <= 1 + slack;
    return is_inside && part > 0 ? part : none; // none, too, if a value is NaN
  }

  double
  operator()(const SimulatedDisc& shape) const
  {
    const double part =
        shape.normal.dot(shape.center - from_) / shape.normal.dot(along_);
    const double off = (from_ + part * along_ - shape.center).norm();
    return off <= shape.radius && part > 0 ? part : none;
  }

  double
  operator()(const SimulatedCylinder& shape) const
  {
    const double length = shape.axis.norm();
    const Eigen::Vector3d axis = shape.axis / length;
    const Eigen::Vector3d start = from_ - shape.base;
    const Eigen::Vector3d across = along_ - along_.dot(axis) * axis;
    const Eigen::Vector3d off = start - start.dot(axis) * axis;
    const double a = across.squaredNorm(), half_b = across.dot(off),
                 c = off.squaredNorm() - shape.radius * shape.radius;
    const double root = std::sqrt(half_b * half_b - a * c); // NaN if it is missed
    for (const double part : {(-half_b - root) / a, (-half_b + root) / a}) {
      const double height = (start + part * along_).dot(axis);
      if (part > 0 && height >= 0 && height <= length)
        return part;
    }
    return none;
  }

private:
  static constexpr double none = std::numeric_limits<double>::infinity();
  static constexpr double slack = 1e-9;
  Eigen::Vector3d from_;
  Eigen::Vector3d along_;
};

/** \brief Which points the cameras of a scene see. */
class Sight {
public:
  explicit Sight(const SimulatedScene& scene)
  : scene_(scene)
  {
    for (const Eigen::Isometry3d& view : scene.views)
      T_camera_scene_.push_back(view.inverse());
  }

  bool
  sees(const Eigen::Vector3d& place)
  {
    for (std::size_t view = 0; view < scene_.views.size(); ++view)
      if (isInImage(T_camera_scene_[view] * place) &&
          !isHidden(scene_.views[view].translation(), place))
        return true;
    return false;
  }

private:
  bool
  isInImage(const Eigen::Vector3d& point) const
  {
    const TrinocularRig& rig = scene_.rig;
    if (!(point.z() > 0 && point.z() <= scene_.sensor.reach))
      return false;
    const double column = rig.focal_length * point.x() / point.z() + rig.center_x;
    const double row = rig.focal_length * point.y() / point.z() + rig.center_y;
    return column >= -0.5 && column <= rig.width - 0.5 && row >= -0.5 &&
           row <= rig.height - 0.5;
  }

  bool
  isHidden(const Eigen::Vector3d& camera, const Eigen::Vector3d& place)
  {
    constexpr double before_it = 1 - 1e-6;
    const Hit hit(camera, place);
    const auto& surfaces = scene_.geometry.surfaces();
    // Neighbouring points are usually hidden by the same surface.
    if (std::visit(hit, surfaces[last_].shape) < before_it)
      return true;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
      if (std::visit(hit, surfaces[i].shape) < before_it) {
        last_ = i;
        return true;
      }
    return false;
  }

  const SimulatedScene& scene_;
  std::vector<Eigen::Isometry3d> T_camera_scene_;
  std::size_t last_ = 0;
};

FlatLoop
cornersOf(const SimulatedRectangle& shape, const PlaneFrame& frame)
{
  const Eigen::Vector3d opposite = shape.corner + shape.edge_u + shape.edge_v;
  return {frame.flat(shape.corner),
          frame.flat(shape.corner + shape.edge_u),
          frame.flat(opposite),
          frame.flat(shape.corner + shape.edge_v)};
}

VisibleFace
makeFace(const TruthPlane& plane, Sight& sight)
{
  VisibleFace face;
  face.coefficients = plane.coefficients;
  const SimulatedRectangle& first = plane.rectangles.front();
  face.frame.origin = first.corner;
  face.frame.u = first.edge_u.normalized();
  face.frame.v = first.edge_v.normalized();
  std::vector<FlatLoop> loops;
  for (const SimulatedRectangle& rectangle : plane.rectangles)
    loops.push_back(cornersOf(rectangle, face.frame));
  const Eigen::AlignedBox2d box = boxOf(loops);
  face.all = CellSet(box);
  for (const FlatLoop& loop : loops)
    face.all.addInside({loop});
  face.seen = CellSet(box);
  face.all.forEach([&](int i, int j) {
    if (sight.sees(face.frame.lifted(cellCenter(i, j))))
      face.seen.add(i, j);
  });
  return face;
}

/** \brief Directions in a face that lead away from a line in it. */
class BesideLine {
public:
  BesideLine(const VisibleFace& face, const Eigen::Vector3d& direction)
  : face_(face)
  , across_(face.coefficients.head<3>().cross(direction).normalized())
  {}

  /** \brief Does the face begin at this point of the line, and was it seen there? */
  bool
  isSeen(const Eigen::Vector3d& point) const
  {
    const auto isSeenOn = [&](double side) {
      const auto at = [&](double metres) {
        return face_.frame.flat(point + side * metres * across_);
      };
      return face_.all.hasPlace(at(0.005)) && face_.seen.hasPlace(at(0.025)) &&
             face_.seen.hasPlace(at(0.035));
    };
    return isSeenOn(1) || isSeenOn(-1);
  }

private:
  const VisibleFace& face_;
  Eigen::Vector3d across_;
};

/** \brief Part of a line beside which a plane has rectangles. */
std::pair<double, double>
extentAlong(const TruthPlane& plane,
            const Eigen::Vector3d& point,
            const Eigen::Vector3d& direction)
{
  std::pair<double, double> extent{std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity()};
  for (const SimulatedRectangle& shape : plane.rectangles)
    for (const Eigen::Vector3d& corner :
         {shape.corner,
          Eigen::Vector3d(shape.corner + shape.edge_u),
          Eigen::Vector3d(shape.corner + shape.edge_v),
          Eigen::Vector3d(shape.corner + shape.edge_u + shape.edge_v)}) {
      const double along = (corner - point).dot(direction);
      extent.first = std::min(extent.first, along);
      extent.second = std::max(extent.second, along);
    }
  return extent;
}

void
addCrease(const std::vector<TruthPlane>& planes,
          std::size_t a,
          std::size_t b,
          VisibleTruth& truth)
{
  const Eigen::Vector4d& plane_a = planes[a].coefficients;
  const Eigen::Vector4d& plane_b = planes[b].coefficients;
  const Eigen::Vector3d cross =
      plane_a.head<3>().cross(Eigen::Vector3d(plane_b.head<3>()));
  if (cross.norm() < min_sine)
    return;
  const Eigen::Vector3d direction = cross.normalized();
  Eigen::Matrix3d equations;
  equations << plane_a.head<3>().transpose(), plane_b.head<3>().transpose(),
      direction.transpose();
  const Eigen::Vector3d point =
      equations.inverse() * Eigen::Vector3d(-plane_a[3], -plane_b[3], 0);
  const auto of_a = extentAlong(planes[a], point, direction);
  const auto of_b = extentAlong(planes[b], point, direction);
  const BesideLine beside_a(truth.faces[a], direction),
      beside_b(truth.faces[b], direction);
  const double end = std::min(of_a.second, of_b.second);
  for (double at = std::max(of_a.first, of_b.first) + raster_cell / 2; at < end;
       at += raster_cell) {
    const Eigen::Vector3d place = point + at * direction;
    if (beside_a.isSeen(place) && beside_b.isSeen(place))
      truth.creases.push_back({place, {a, b}});
  }
}

/** \brief The true planes of a scene, those that are in one plane as one. */
std::vector<TruthPlane>
distinctPlanes(const SceneGeometry& geometry)
{
  constexpr double same = 1e-6;
  std::vector<TruthPlane> planes;
  for (const TruthPlane& plane : geometry.planes()) {
    const auto known =
        std::find_if(planes.begin(), planes.end(), [&](const TruthPlane& other) {
          return (other.coefficients - plane.coefficients).norm() < same;
        });
    if (known == planes.end()) {
      planes.push_back(plane);
      continue;
    }
    known->rectangles.insert(
        known->rectangles.end(), plane.rectangles.begin(), plane.rectangles.end());
  }
  return planes;
}

/** \brief Is a place a corner of the face's boundary, and was the face seen around it?
 */
bool
isSeenCorner(const VisibleFace& face, const Eigen::Vector2d& place)
{
  constexpr double beside = 0.025; // metres
  int count = 0;
  bool is_seen = true, on_diagonal[2] = {false, false};
  for (const int u : {-1, 1})
    for (const int v : {-1, 1}) {
      const Eigen::Vector2d near = place + beside * Eigen::Vector2d(u, v);
      if (!face.all.hasPlace(near))
        continue;
      ++count;
      on_diagonal[u == v] = true;
      is_seen = is_seen && face.seen.hasPlace(near);
    }
  const bool is_edge = count == 2 && on_diagonal[0] && on_diagonal[1];
  return is_seen && count > 0 && count < 4 && !is_edge;
}

void
addCorners(const TruthPlane& plane, const VisibleFace& face, VisibleTruth& truth)
{
  constexpr double same = 1e-3; // metres
  for (const SimulatedRectangle& rectangle : plane.rectangles)
    for (const Eigen::Vector2d& place : cornersOf(rectangle, face.frame)) {
      const Eigen::Vector3d corner = face.frame.lifted(place);
      const bool is_known = std::any_of(
          truth.corners.begin(),
          truth.corners.end(),
          [&](const Eigen::Vector3d& known) { return (known - corner).norm() < same; });
      if (!is_known && isSeenCorner(face, place))
        truth.corners.push_back(corner);
    }
}

} // namespace

double
VisibleTruth::seenArea() const
{
  double sum = 0;
  for (const VisibleFace& face : faces)
    sum += face.seen.area();
  return sum;
}

VisibleTruth
findVisibleTruth(const SimulatedScene& scene)
{
  VisibleTruth truth;
  const std::vector<TruthPlane> planes = distinctPlanes(scene.geometry);
  Sight sight(scene);
  for (const TruthPlane& plane : planes)
    truth.faces.push_back(makeFace(plane, sight));
  for (std::size_t a = 0; a < planes.size(); ++a) {
    for (std::size_t b = a + 1; b < planes.size(); ++b)
      addCrease(planes, a, b, truth);
    addCorners(planes[a], truth.faces[a], truth);
  }
  return truth;
}

} // namespace pcl::acmap::bench
