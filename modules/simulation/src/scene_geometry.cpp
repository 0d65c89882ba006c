#include <pcl/core/exceptions.h>
#include <pcl/simulation/scene_geometry.h>

#include <pcl/core/impl/arguments.h>

#include <algorithm>
#include <cmath>

namespace pcl {

namespace {

constexpr double shortest_edge = 1e-3; // metres
constexpr double farthest = 1e4;       // metres
constexpr double plane_slack = 1e-6;   // metres
constexpr double right_angle_slack = 1e-9;
constexpr double strongest_texture = 255; // grey levels
constexpr std::size_t max_surfaces = 100000;

void
requirePlace(const std::string& name, const Eigen::Vector3d& place)
{
  for (int axis = 0; axis < 3; ++axis)
    acmap::requireInRange(name, place[axis], -farthest, farthest, "m");
}

void
requireSound(const std::string& name, const SimulatedRectangle& rectangle)
{
  requirePlace(name + ": corner", rectangle.corner);
  requirePlace(name + ": edge", rectangle.edge_u);
  requirePlace(name + ": edge", rectangle.edge_v);
  const double u = rectangle.edge_u.norm();
  const double v = rectangle.edge_v.norm();
  acmap::requireInRange(name + ": length of an edge", u, shortest_edge, farthest, "m");
  acmap::requireInRange(name + ": length of an edge", v, shortest_edge, farthest, "m");
  const double cosine = rectangle.edge_u.dot(rectangle.edge_v) / (u * v);
  if (std::abs(cosine) > right_angle_slack)
    acmap::refuseArgument(
        name + ": cosine of the angle between the edges", cosine, "0");
}

void
requireSound(const std::string& name, const SurfaceLook& look)
{
  acmap::requireInRange(
      name + ": texture", look.texture, 0.0, strongest_texture, "grey levels");
}

double
distanceTo(const TruthPlane& plane, const Eigen::Vector3d& point)
{
  return plane.coefficients.head<3>().dot(point) + plane.coefficients[3];
}

void
requireInPlane(const TruthPlane& plane, const SimulatedRectangle& rectangle)
{
  const Eigen::Vector3d opposite =
      rectangle.corner + rectangle.edge_u + rectangle.edge_v;
  for (const Eigen::Vector3d& corner :
       {rectangle.corner,
        Eigen::Vector3d(rectangle.corner + rectangle.edge_u),
        opposite,
        Eigen::Vector3d(rectangle.corner + rectangle.edge_v)})
    if (!(std::abs(distanceTo(plane, corner)) <= plane_slack))
      acmap::refuseArgument("distance of a rectangle's corner from its plane '" +
                                plane.name + "'",
                            distanceTo(plane, corner),
                            "within 1e-6 m of 0");
  if (rectangle.normal().dot(plane.coefficients.head<3>()) < 0.0)
    throw acmap::BadArgument("a rectangle looks to the other side than its plane '" +
                             plane.name + "': exchange its edges");
}

} // namespace

double
TruthPlane::area() const
{
  double sum = 0;
  for (const SimulatedRectangle& rectangle : rectangles)
    sum += rectangle.edge_u.norm() * rectangle.edge_v.norm();
  return sum;
}

TruthPlane
transformPlane(const TruthPlane& plane, const Eigen::Isometry3d& T_a_b)
{
  TruthPlane moved;
  moved.name = plane.name;
  const Eigen::Vector3d normal = T_a_b.linear() * plane.coefficients.head<3>();
  moved.coefficients << normal, plane.coefficients[3] - normal.dot(T_a_b.translation());
  for (const SimulatedRectangle& rectangle : plane.rectangles)
    moved.rectangles.push_back({T_a_b * rectangle.corner,
                                T_a_b.linear() * rectangle.edge_u,
                                T_a_b.linear() * rectangle.edge_v});
  return moved;
}

void
SceneGeometry::addSurface(SimulatedSurface surface)
{
  if (surfaces_.size() == max_surfaces)
    throw acmap::BadArgument("a scene has at most " + std::to_string(max_surfaces) +
                             " surfaces");
  surfaces_.push_back(std::move(surface));
}

std::int32_t
SceneGeometry::joinPlane(const std::string& plane, const SimulatedRectangle& rectangle)
{
  const auto known = std::find_if(
      planes_.begin(), planes_.end(), [&](const auto& p) { return p.name == plane; });
  const auto id = static_cast<std::int32_t>(known - planes_.begin());
  if (known != planes_.end()) {
    requireInPlane(*known, rectangle);
    known->rectangles.push_back(rectangle);
    return id;
  }
  TruthPlane& added = planes_.emplace_back();
  added.name = plane;
  const Eigen::Vector3d normal = rectangle.normal();
  added.coefficients << normal, -normal.dot(rectangle.corner);
  added.rectangles.push_back(rectangle);
  return id;
}

void
SceneGeometry::addRectangle(const std::string& name,
                            const std::string& plane,
                            const SimulatedRectangle& rectangle,
                            const SurfaceLook& look)
{
  requireSound(name, rectangle);
  requireSound(name, look);
  addSurface({name, rectangle, joinPlane(plane, rectangle), look});
}

void
SceneGeometry::addBox(const std::string& name,
                      const Eigen::Vector3d& minimum,
                      const Eigen::Vector3d& maximum,
                      const SurfaceLook& look,
                      const BoxFaces& faces)
{
  const Eigen::Vector3d size = maximum - minimum;
  for (int axis = 0; axis < 3; ++axis)
    acmap::requireInRange(
        name + ": length of an edge", size[axis], shortest_edge, farthest, "m");
  SceneGeometry extended(*this); // add all faces or none
  const Eigen::Vector3d x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
  const auto add = [&](bool wanted, const char* face, const SimulatedRectangle& shape) {
    if (wanted)
      extended.addRectangle(name + " " + face, name + " " + face, shape, look);
  };
  add(faces.left, "left", {minimum, z, y});
  add(faces.right, "right", {minimum + x, y, z});
  add(faces.top, "top", {minimum, x, z});
  add(faces.bottom, "bottom", {minimum + y, z, x});
  add(faces.front, "front", {minimum, y, x});
  add(faces.back, "back", {minimum + z, x, y});
  *this = std::move(extended);
}

void
SceneGeometry::addCylinder(const std::string& name,
                           const SimulatedCylinder& cylinder,
                           const SurfaceLook& look,
                           bool caps)
{
  requireSound(name, look);
  requirePlace(name + ": base", cylinder.base);
  requirePlace(name + ": axis", cylinder.axis);
  acmap::requireInRange(
      name + ": radius", cylinder.radius, shortest_edge, farthest, "m");
  const double length = cylinder.axis.norm();
  acmap::requireInRange(name + ": length", length, shortest_edge, farthest, "m");
  addSurface({name, cylinder, -1, look});
  if (!caps)
    return;
  const Eigen::Vector3d up = cylinder.axis / length;
  addSurface(
      {name + " base", SimulatedDisc{cylinder.base, -up, cylinder.radius}, -1, look});
  addSurface({name + " top",
              SimulatedDisc{cylinder.base + cylinder.axis, up, cylinder.radius},
              -1,
              look});
}

void
SceneGeometry::addMoved(const SceneGeometry& other,
                        const Eigen::Vector3d& shift,
                        const std::string& suffix)
{
  const auto first = static_cast<std::int32_t>(planes_.size());
  const Eigen::Isometry3d move(Eigen::Translation3d{shift});
  for (TruthPlane plane : other.planes_) {
    plane = transformPlane(plane, move);
    plane.name += suffix;
    planes_.push_back(std::move(plane));
  }
  const auto moved = [&](Eigen::Vector3d& point) { point += shift; };
  for (SimulatedSurface surface : other.surfaces_) {
    surface.name += suffix;
    if (surface.plane >= 0)
      surface.plane += first;
    if (auto* const rectangle = std::get_if<SimulatedRectangle>(&surface.shape))
      moved(rectangle->corner);
    else if (auto* const cylinder = std::get_if<SimulatedCylinder>(&surface.shape))
      moved(cylinder->base);
    else
      moved(std::get<SimulatedDisc>(surface.shape).center);
    surfaces_.push_back(std::move(surface));
  }
}

} // namespace pcl
