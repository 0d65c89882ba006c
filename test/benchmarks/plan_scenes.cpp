#include "plan_scenes.h"

#include "bench_data.h"
#include "temporary_folder.h"

#include <pcl/simulation/standard_scenes.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <tuple>

namespace pcl::acmap::bench {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/** \brief A product of a model. */
struct Shape {
  std::string type, filling;
  std::vector<std::array<Vector3d, 3>> triangles; ///< frame of the scene
  bool is_opaque = true;

  Eigen::AlignedBox3d
  box() const
  {
    Eigen::AlignedBox3d box;
    for (const auto& triangle : triangles)
      for (const Vector3d& corner : triangle)
        box.extend(corner);
    return box;
  }
};

/** \brief Reads what test/npm/ifc_shapes.mjs writes; x right, y down, z forward. */
std::vector<Shape>
readShapes(const std::string& path)
{
  std::vector<Shape> shapes;
  std::vector<Vector3d> vertices;
  std::ifstream file(path);
  bool is_opaque = true;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "o") {
      std::string number;
      words >> number >> shapes.emplace_back().type;
      words >> shapes.back().filling;
    }
    else if (kind == "usemtl") {
      std::string material;
      words >> material;
      is_opaque = material == "opaque";
    }
    else if (kind == "v") {
      Vector3d place;
      words >> place.x() >> place.y() >> place.z();
      vertices.emplace_back(place.x(), -place.y(), -place.z());
    }
    else if (kind == "f") {
      std::array<std::size_t, 3> corners{};
      words >> corners[0] >> corners[1] >> corners[2];
      if (is_opaque || shapes.back().type == "IfcSpace" ||
          shapes.back().type == "IfcOpeningElement")
        shapes.back().triangles.push_back({vertices[corners[0] - 1],
                                           vertices[corners[1] - 1],
                                           vertices[corners[2] - 1]});
    }
  }
  return shapes;
}

/** \brief Triangles in one plane, as rectangles along its axes. */
class FlatPart {
public:
  explicit FlatPart(const Vector3d& normal, const Vector3d& origin)
  : normal_(normal)
  , origin_(origin)
  {
    const Vector3d up = -Vector3d::UnitY();
    const Vector3d level = up.cross(normal);
    u_ =
        level.norm() > 0.1 ? Vector3d(level.normalized()) : Vector3d(Vector3d::UnitX());
    v_ = normal.cross(u_);
  }

  bool
  takes(const Vector3d& normal, const Vector3d& place) const
  {
    return normal.dot(normal_) > 0.9999 &&
           std::abs(normal_.dot(place - origin_)) < 1e-4;
  }

  void
  add(const std::array<Vector3d, 3>& triangle)
  {
    auto& flat = triangles_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      flat[k] = {u_.dot(triangle[k] - origin_), v_.dot(triangle[k] - origin_)};
  }

  std::vector<SimulatedRectangle>
  rectangles() const
  {
    constexpr double fine = 0.1, same = 0.01; // metres, share of the area
    double area = 0;
    for (const auto& t : triangles_)
      area += std::abs(cross(t[1] - t[0], t[2] - t[0])) / 2;
    std::vector<SimulatedRectangle> all = cellsBetween(0);
    double covered = 0;
    for (const SimulatedRectangle& one : all)
      covered += one.edge_u.norm() * one.edge_v.norm();
    return std::abs(covered - area) <= same * area ? all : cellsBetween(fine);
  }

private:
  static double
  cross(const Vector2d& a, const Vector2d& b)
  {
    return a.x() * b.y() - a.y() * b.x();
  }

  bool
  contains(const Vector2d& place) const
  {
    return std::any_of(triangles_.begin(), triangles_.end(), [&](const auto& t) {
      const double a = cross(t[1] - t[0], place - t[0]),
                   b = cross(t[2] - t[1], place - t[1]),
                   c = cross(t[0] - t[2], place - t[2]);
      return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
    });
  }

  /** \brief All corners along an axis, ascending, and places between them. */
  std::vector<double>
  limits(int axis, double step) const
  {
    constexpr double same = 1e-3; // metres
    std::vector<double> all;
    for (const auto& triangle : triangles_)
      for (const Vector2d& corner : triangle)
        all.push_back(corner[axis]);
    std::sort(all.begin(), all.end());
    std::vector<double> distinct;
    for (const double one : all) {
      if (!distinct.empty() && one - distinct.back() < same)
        continue;
      if (step > 0 && !distinct.empty()) {
        const double from = distinct.back();
        const auto parts = static_cast<int>(std::ceil((one - from) / step));
        for (int k = 1; k < parts; ++k)
          distinct.push_back(from + (one - from) * k / parts);
      }
      distinct.push_back(one);
    }
    return distinct;
  }

  /** \brief Cells whose middle is covered, those beside each other as one. */
  std::vector<SimulatedRectangle>
  cellsBetween(double step) const
  {
    const std::vector<double> us = limits(0, step), vs = limits(1, step);
    std::vector<SimulatedRectangle> all;
    for (std::size_t j = 0; j + 1 < vs.size(); ++j)
      for (std::size_t i = 0; i + 1 < us.size();) {
        const auto isCovered = [&](std::size_t column) {
          return column + 1 < us.size() &&
                 contains({(us[column] + us[column + 1]) / 2, (vs[j] + vs[j + 1]) / 2});
        };
        std::size_t end = i;
        while (isCovered(end))
          ++end;
        if (end > i)
          all.push_back({origin_ + us[i] * u_ + vs[j] * v_,
                         (us[end] - us[i]) * u_,
                         (vs[j + 1] - vs[j]) * v_});
        i = end + 1;
      }
    return all;
  }

  Vector3d normal_, origin_, u_, v_;
  std::vector<std::array<Vector2d, 3>> triangles_;
};

/** \brief Is it one of many small triangles, such as a chair? Then it becomes its box. */
bool
isFine(const Shape& shape)
{
  constexpr std::size_t many = 300;
  return shape.type == "IfcFurnishingElement" && shape.triangles.size() > many;
}

/** \brief The sides of a box, as triangles that look outwards. */
std::vector<std::array<Vector3d, 3>>
sidesOf(const Eigen::AlignedBox3d& box)
{
  std::vector<std::array<Vector3d, 3>> triangles;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-0.5, 0.5}) {
      const auto at = [&](double u, double v) -> Vector3d {
        Vector3d off;
        off[axis] = side;
        off[(axis + 1) % 3] = side > 0 ? u : v;
        off[(axis + 2) % 3] = side > 0 ? v : u;
        return box.center() + off.cwiseProduct(box.sizes());
      };
      triangles.push_back({at(-0.5, -0.5), at(0.5, -0.5), at(0.5, 0.5)});
      triangles.push_back({at(-0.5, -0.5), at(0.5, 0.5), at(-0.5, 0.5)});
    }
  return triangles;
}

/** \brief Adds a product as rectangles. */
void
addShape(const Shape& shape, const std::string& name, SceneGeometry& geometry)
{
  const SurfaceLook look{{160, 160, 160}, 4};
  std::vector<FlatPart> parts;
  for (const auto& triangle : shape.triangles) {
    const Vector3d normal =
        (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    if (normal.norm() < 1e-9)
      continue;
    const Vector3d unit = normal.normalized();
    auto part = std::find_if(parts.begin(), parts.end(), [&](const FlatPart& one) {
      return one.takes(unit, triangle[0]);
    });
    if (part == parts.end()) {
      parts.emplace_back(unit, triangle[0]);
      part = parts.end() - 1;
    }
    part->add(triangle);
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const SimulatedRectangle& rectangle : parts[p].rectangles())
      if (rectangle.edge_u.norm() > 2e-3 && rectangle.edge_v.norm() > 2e-3)
        geometry.addRectangle(name, name + " " + std::to_string(p), rectangle, look);
}

/** \brief Where a level plane cuts a triangle; seen from the left. */
std::optional<TrueFace>
cutOf(const std::array<Vector3d, 3>& triangle, double y, int wall)
{
  std::vector<Vector2d> ends;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3d &a = triangle[k], &b = triangle[(k + 1) % 3];
    if ((a.y() > y) != (b.y() > y)) {
      const Vector3d place = a + (y - a.y()) / (b.y() - a.y()) * (b - a);
      ends.emplace_back(place.x(), place.z());
    }
  }
  if (ends.size() != 2 || (ends[1] - ends[0]).norm() < 1e-6)
    return {};
  const Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const Vector2d way = ends[1] - ends[0], left(-way.y(), way.x());
  if (left.dot(Vector2d(normal.x(), normal.z())) < 0)
    std::swap(ends[0], ends[1]);
  return TrueFace{ends[0], ends[1], wall};
}

/** \brief Where a level plane cuts a product. Models have triangles that look inwards, too. */
std::vector<TrueFace>
cutOf(const Shape& shape, double y, int wall)
{
  std::vector<TrueFace> faces;
  for (const auto& triangle : shape.triangles)
    if (const auto face = cutOf(triangle, y, wall))
      faces.push_back(*face);
  const auto isInside = [&](const Vector2d& place) {
    bool is_inside = false;
    for (const TrueFace& face : faces)
      if ((face.from.y() > place.y()) != (face.to.y() > place.y()) &&
          place.x() < face.from.x() + (place.y() - face.from.y()) /
                                          (face.to.y() - face.from.y()) *
                                          (face.to.x() - face.from.x()))
        is_inside = !is_inside;
    return is_inside;
  };
  std::vector<TrueFace> outwards = faces;
  constexpr double off = 1e-3; // metres
  for (TrueFace& face : outwards) {
    const Vector2d along = (face.to - face.from).normalized();
    if (isInside((face.from + face.to) / 2 + off * Vector2d(-along.y(), along.x())))
      std::swap(face.from, face.to);
  }
  return outwards;
}

bool
startsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

/** \brief The opening of a wall whose void is a box along the axes. */
TrueOpening
openingOf(const Shape& shape, double floor)
{
  const Eigen::AlignedBox3d box = shape.box();
  const Vector3d middle = box.center();
  TrueOpening opening;
  if (box.sizes().x() > box.sizes().z()) {
    opening.from = {box.min().x(), middle.z()};
    opening.to = {box.max().x(), middle.z()};
  }
  else {
    opening.from = {middle.x(), box.min().z()};
    opening.to = {middle.x(), box.max().z()};
  }
  opening.is_window = shape.filling == "IfcWindow";
  opening.bottom = floor - box.max().y();
  opening.top = floor - box.min().y();
  return opening;
}

/** \brief Places in a space, far from its walls and from each other. */
std::vector<Vector2d>
placesIn(const Shape& space, const PlanScene& scene)
{
  constexpr double step = 0.2, near = 0.45; // metres
  std::vector<TrueFace> border;
  for (const auto& triangle : space.triangles)
    if (const auto cut = cutOf(triangle, scene.floor - section_height, 0))
      border.push_back(*cut);
  const Eigen::AlignedBox3d box = space.box();
  std::vector<std::pair<double, Vector2d>> free; // with the distance to the next wall
  for (double x = box.min().x(); x < box.max().x(); x += step)
    for (double z = box.min().z(); z < box.max().z(); z += step) {
      bool is_inside = false;
      double distance = std::numeric_limits<double>::infinity();
      const Vector2d place(x + step / 2, z + step / 2);
      for (const TrueFace& face : border)
        if ((face.from.y() > place.y()) != (face.to.y() > place.y()) &&
            place.x() < face.from.x() + (place.y() - face.from.y()) /
                                            (face.to.y() - face.from.y()) *
                                            (face.to.x() - face.from.x()))
          is_inside = !is_inside;
      for (const std::vector<TrueFace>* faces : {&std::as_const(border), &scene.faces})
        for (const TrueFace& face : *faces) {
          const Vector2d way = face.to - face.from;
          const double share =
              std::clamp(way.dot(place - face.from) / way.squaredNorm(), 0.0, 1.0);
          distance = std::min(distance, (face.from + share * way - place).norm());
        }
      if (is_inside && distance > near)
        free.emplace_back(distance, place);
    }
  const double area = static_cast<double>(free.size()) * step * step;
  const std::size_t wanted = area > 20 ? 4 : area > 8 ? 3 : area > 3 ? 2 : 1;
  std::vector<Vector2d> places;
  while (places.size() < wanted && !free.empty()) {
    const auto merit = [&](const std::pair<double, Vector2d>& one) {
      double least = places.empty() ? one.first : 1e9;
      for (const Vector2d& other : places)
        least = std::min(least, (one.second - other).norm());
      return least;
    };
    places.push_back(
        std::max_element(free.begin(), free.end(), [&](const auto& a, const auto& b) {
          return merit(a) < merit(b);
        })->second);
  }
  return places;
}

/** \brief Cameras that look all around, level, down and up. */
void
addViews(const Vector2d& place, double y, std::vector<Eigen::Isometry3d>& views)
{
  constexpr int turns = 10;
  for (const double pitch : {0.0, 0.7, -0.7})
    for (int k = 0; k < turns; ++k) {
      Eigen::Isometry3d view(Eigen::Translation3d(place.x(), y, place.y()));
      view.rotate(Eigen::AngleAxisd(2 * M_PI * k / turns, Vector3d::UnitY()));
      view.rotate(Eigen::AngleAxisd(pitch, Vector3d::UnitX()));
      views.push_back(view);
    }
}

/** \brief Triangulates a model with web-ifc. */
std::optional<std::string>
shapesOf(const std::string& model, const test::TemporaryFolder& folder)
{
  const auto path = pathOfData("I_ifc/" + model + ".ifc.xz");
  if (!path)
    return {};
  const std::string unpacked = folder.path("model.ifc"),
                    shapes = folder.path("shapes.obj");
  std::ofstream(unpacked, std::ios::binary) << contentOf(*path);
  const std::string command = "node '" ACMAP_NPM "/ifc_shapes.mjs' '" + unpacked +
                              "' '" + shapes + "' 2>/dev/null";
  if (std::system(command.c_str()) == 0)
    return shapes;
  std::cerr << "left out: no node, or no web-ifc: npm ci --prefix test/npm brings it\n";
  return {};
}

} // namespace

bool
PlanScene::isSeen(const Vector2d& place, const Vector2d& normal) const
{
  constexpr double off = 0.02, min_cosine = 0.15, nearest = 0.2; // metres
  const Vector2d target = place + off * normal;
  const auto isFree = [&](const Vector2d& camera) {
    return std::none_of(faces.begin(), faces.end(), [&](const TrueFace& face) {
      const auto side = [](const Vector2d& p, const Vector2d& q, const Vector2d& r) {
        return (q - p).x() * (r - p).y() - (q - p).y() * (r - p).x();
      };
      return (side(camera, target, face.from) > 0) !=
                 (side(camera, target, face.to) > 0) &&
             (side(face.from, face.to, camera) > 0) !=
                 (side(face.from, face.to, target) > 0);
    });
  };
  const Vector3d in_scene(target.x(), floor - section_height, target.y());
  return std::any_of(scene.views.begin(), scene.views.end(), [&](const auto& view) {
    const Vector3d seen = view.inverse() * in_scene;
    const TrinocularRig& rig = scene.rig;
    const double column = rig.focal_length * seen.x() / seen.z() + rig.center_x;
    const double row = rig.focal_length * seen.y() / seen.z() + rig.center_y;
    const Vector2d camera(view.translation().x(), view.translation().z());
    const Vector2d way = camera - target;
    return seen.z() > nearest && seen.z() < scene.sensor.reach && column > 0 &&
           row > 0 && column < rig.width && row < rig.height &&
           way.normalized().dot(normal) > min_cosine && isFree(camera);
  });
}

PlanScene
standardPlanScene(const std::string& name)
{
  constexpr double wall_height = 2.5; // metres
  PlanScene result;
  result.name = name;
  result.scene = standardScene(name);
  const SceneGeometry& geometry = result.scene.geometry;
  for (const SimulatedSurface& surface : geometry.surfaces())
    if (surface.name == "floor")
      result.floor = std::get<SimulatedRectangle>(surface.shape).corner.y();
  const double y = result.floor - section_height;
  for (std::size_t p = 0; p < geometry.planes().size(); ++p) {
    double low = 1e9, high = -1e9;
    for (const SimulatedRectangle& one : geometry.planes()[p].rectangles)
      for (const double end :
           {one.corner.y(), one.corner.y() + one.edge_u.y() + one.edge_v.y()}) {
        low = std::min(low, end);
        high = std::max(high, end);
      }
    const int wall = high - low >= wall_height ? static_cast<int>(p) : -1;
    for (const SimulatedRectangle& one : geometry.planes()[p].rectangles) {
      const Vector3d opposite = one.corner + one.edge_u + one.edge_v;
      for (const auto& triangle :
           {std::array<Vector3d, 3>{one.corner, one.corner + one.edge_u, opposite},
            std::array<Vector3d, 3>{one.corner, opposite, one.corner + one.edge_v}})
        if (const auto cut = cutOf(triangle, y, wall))
          result.faces.push_back(*cut);
    }
  }
  const auto& surfaces = geometry.surfaces();
  for (const SimulatedSurface& surface : surfaces)
    if (std::any_of(surfaces.begin(), surfaces.end(), [&](const auto& other) {
          return other.name == surface.name + " reveal";
        })) {
      const auto& panel = std::get<SimulatedRectangle>(surface.shape);
      const Vector3d to = panel.corner + panel.edge_u;
      result.openings.push_back({{panel.corner.x(), panel.corner.z()},
                                 {to.x(), to.z()},
                                 false,
                                 0,
                                 panel.edge_v.norm()});
    }
  return result;
}

std::optional<PlanScene>
modelPlanScene(const std::string& model, double floor)
{
  const test::TemporaryFolder folder;
  const auto path = shapesOf(model, folder);
  if (!path)
    return {};
  std::vector<Shape> shapes = readShapes(*path);
  PlanScene result;
  result.name = model + ", " + std::to_string(floor).substr(0, 3) + " m";
  result.floor = -floor;
  const double y = result.floor - section_height;
  result.scene.name = model;
  result.scene.rig = standardScene("room").rig;
  result.scene.sensor.points = 12000;
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    Shape& shape = shapes[s];
    const bool is_hole = shape.type == "IfcOpeningElement" ||
                         shape.type == "IfcSpace" || shape.type == "IfcDoor" ||
                         shape.type == "IfcWindow" || shape.type == "IfcSite" ||
                         shape.type == "IfcRailing";
    if (is_hole)
      continue;
    if (isFine(shape))
      shape.triangles = sidesOf(shape.box());
    addShape(shape, shape.type + " " + std::to_string(s), result.scene.geometry);
    const int wall = startsWith(shape.type, "IfcWall") ? static_cast<int>(s) : -1;
    for (const TrueFace& face : cutOf(shape, y, wall))
      result.faces.push_back(face);
  }
  for (const Shape& shape : shapes) {
    const Eigen::AlignedBox3d box = shape.box();
    if (shape.triangles.empty() || box.min().y() > y || box.max().y() < y)
      continue;
    if (shape.type == "IfcOpeningElement" && !shape.filling.empty())
      result.openings.push_back(openingOf(shape, result.floor));
    if (shape.type == "IfcSpace")
      for (const Vector2d& place : placesIn(shape, result))
        addViews(place, y, result.scene.views);
  }
  return result;
}

} // namespace pcl::acmap::bench
