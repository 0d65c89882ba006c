#include "plan/plan_contents.h"

#include "plan/opening_faces.h"
#include "plan/plan_drawing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double lowest_furniture = 0.3; // metres above the floor

/** \brief The corners of the smallest convex polygon around points, counter-clockwise. */
std::vector<Vector2d>
hullOf(std::vector<Vector2d> points)
{
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  std::vector<Vector2d> hull;
  const auto add = [&](const Vector2d& point, std::size_t first) {
    const auto turnsRight = [&] {
      const Vector2d way = hull.back() - hull[hull.size() - 2],
                     next = point - hull.back();
      return way.x() * next.y() - way.y() * next.x() <= 0;
    };
    while (hull.size() > first + 1 && turnsRight())
      hull.pop_back();
    hull.push_back(point);
  };
  for (const Vector2d& point : points)
    add(point, 0);
  const std::size_t upper = hull.size() - 1;
  for (auto point = points.rbegin() + 1; point < points.rend(); ++point)
    add(*point, upper);
  hull.pop_back();
  return hull;
}

/** \brief Finds them. */
class ContentsFinder {
public:
  ContentsFinder(const CompactMap& map, FloorPlan& plan)
  : map_(map)
  , plan_(plan)
  {
    for (const PlanePatch& plane : map.planes)
      if (std::abs(plane.coefficients.head<3>().dot(plan.up)) < upright_cosine)
        for (const PlanePolygon& polygon : plane.polygons)
          for (const Eigen::Vector3f& place : polygon.outer)
            if (place.allFinite())
              walls_top_ = std::max(walls_top_, plan_.heightOf(place.cast<double>()));
    for (const BoxPatch& box : map.boxes)
      if (isFurniture(box))
        addSides(box);
    for (const RecessPatch& recess : map.recesses)
      if (recess.reaches_floor &&
          isOfSize(recess.leaf, recess.size[0] * recess.size[1]))
        leaves_.insert(recess.leaf);
  }

  void
  find()
  {
    for (PlanWall& wall : plan_.walls)
      wall.role = roleOf(wall.plane);
    for (PlanOpening& opening : plan_.openings)
      findLeaf(opening);
    for (PlanWall& wall : plan_.unseen_walls)
      wall.role = roleOf(wall.plane);
    plan_.unseen_walls.erase(std::remove_if(plan_.unseen_walls.begin(),
                                            plan_.unseen_walls.end(),
                                            [](const PlanWall& wall) {
                                              return wall.role != SurfaceRole::Wall;
                                            }),
                             plan_.unseen_walls.end());
    for (const BoxPatch& box : map_.boxes)
      if (isFurniture(box))
        addBox(box);
    for (std::size_t p = 0; p < map_.planes.size(); ++p)
      addLevel(p);
    for (const CylinderPatch& cylinder : map_.cylinders)
      addCylinder(cylinder);
  }

private:
  /** \brief Has a plane about an area, so that it is no wall that goes on? */
  bool
  isOfSize(std::int32_t plane, double area) const
  {
    constexpr double larger = 1.3;
    return plane >= 0 && static_cast<std::size_t>(plane) < map_.planes.size() &&
           map_.planes[static_cast<std::size_t>(plane)].area < larger * area;
  }

  void
  addSides(const BoxPatch& box)
  {
    for (std::size_t side = 0; side < box.faces.size(); ++side) {
      const auto axis = static_cast<Eigen::Index>(side / 2);
      const BoxFace& face = box.faces[side];
      if (face.kind != BoxFaceKind::Seen && face.kind != BoxFaceKind::Slanted)
        continue;
      box_planes_.insert(face.plane);
      if (isOfSize(face.plane, box.size[(axis + 1) % 3] * box.size[(axis + 2) % 3]))
        box_sides_.insert(face.plane);
    }
  }

  static std::vector<Vector3d>
  cornersOf(const BoxPatch& box)
  {
    std::vector<Vector3d> corners;
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5})
        for (const double z : {-0.5, 0.5})
          corners.emplace_back(box.center +
                               box.axes * box.size.cwiseProduct(Vector3d(x, y, z)));
    return corners;
  }

  /** \brief Lowest and highest corner, above the floor. */
  std::pair<double, double>
  heightsOf(const BoxPatch& box) const
  {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vector3d& corner : cornersOf(box)) {
      low = std::min(low, plan_.heightOf(corner));
      high = std::max(high, plan_.heightOf(corner));
    }
    return {low, high};
  }

  bool
  isFurniture(const BoxPatch& box) const
  {
    constexpr double below = 0.2, shortest = 1.2; // metres
    const auto [low, high] = heightsOf(box);
    return box.center.allFinite() && box.axes.allFinite() && box.size.allFinite() &&
           high > lowest_furniture / 3 && low < plan_.cut - plan_.floor &&
           (high < walls_top_ - below || high < shortest);
  }

  SurfaceRole
  roleOf(std::size_t plane) const
  {
    const auto number = static_cast<std::int32_t>(plane);
    const SurfaceRole role = map_.planes[plane].label.role;
    if (role == SurfaceRole::Furniture || role == SurfaceRole::DoorLeaf)
      return role;
    if (role != SurfaceRole::Other)
      return SurfaceRole::Wall;
    if (leaves_.count(number) > 0)
      return SurfaceRole::DoorLeaf;
    return box_sides_.count(number) > 0 ? SurfaceRole::Furniture : SurfaceRole::Wall;
  }

  /** \brief Finds what closes an opening: pieces of walls parallel to it, behind the seen side,
   * that are not longer than it. */
  void
  findLeaf(PlanOpening& opening)
  {
    constexpr double deepest = 0.35, slack = 0.06, min_cosine = 0.98; // metres
    const Vector2d along = (opening.to - opening.from).normalized();
    const Vector2d front = frontOf(opening);
    const double width = (opening.to - opening.from).norm();
    for (PlanWall& wall : plan_.walls) {
      const double a = along.dot(wall.from - opening.from),
                   b = along.dot(wall.to - opening.from);
      const double behind = -front.dot((wall.from + wall.to) / 2 - opening.from);
      if (std::abs(front.dot(frontOf(wall))) < min_cosine || behind <= 0 ||
          behind > deepest || std::min(a, b) < -slack || std::max(a, b) > width + slack)
        continue;
      wall.role = SurfaceRole::DoorLeaf;
      constexpr double min_share = 0.5;
      if (std::abs(b - a) > min_share * width && !(behind > opening.leaf))
        opening.leaf = behind;
    }
  }

  void
  addBox(const BoxPatch& box)
  {
    std::vector<Vector2d> corners;
    for (const Vector3d& corner : cornersOf(box))
      corners.push_back(plan_.placeOf(corner));
    plan_.furniture.push_back({hullOf(std::move(corners)), heightsOf(box).second});
  }

  void
  addLevel(std::size_t number)
  {
    constexpr double min_area = 0.1; // square metres
    const PlanePatch& plane = map_.planes[number];
    const SurfaceRole role = plane.label.role;
    if (!(plane.coefficients.head<3>().dot(plan_.up) > level_cosine) ||
        !(plane.area >= min_area) || plane.polygons.empty() ||
        plane.polygons.front().outer.empty() ||
        (role != SurfaceRole::Furniture && role != SurfaceRole::Other) ||
        box_planes_.count(static_cast<std::int32_t>(number)) > 0)
      return;
    const double height =
        plan_.heightOf(plane.polygons.front().outer.front().cast<double>());
    if (!(height > lowest_furniture && height < plan_.cut - plan_.floor))
      return;
    for (const PlanePolygon& polygon : plane.polygons) {
      std::vector<Vector2d> outline;
      for (const Eigen::Vector3f& place : polygon.outer)
        if (place.allFinite())
          outline.push_back(plan_.placeOf(place.cast<double>()));
      if (outline.size() > 2 && !isInOpening(outline))
        plan_.furniture.push_back({std::move(outline), height});
    }
  }

  /** \brief Is a level plane the sill of a window? */
  bool
  isInOpening(const std::vector<Vector2d>& outline) const
  {
    Vector2d middle = Vector2d::Zero();
    for (const Vector2d& corner : outline)
      middle += corner / static_cast<double>(outline.size());
    return std::any_of(
        plan_.openings.begin(), plan_.openings.end(), [&](const PlanOpening& opening) {
          const Vector2d along = (opening.to - opening.from).normalized();
          const double behind = -frontOf(opening).dot(middle - opening.from);
          const double aside = along.dot(middle - opening.from);
          return behind > -thickest_wall / 2 && behind < thickest_wall && aside > 0 &&
                 aside < (opening.to - opening.from).norm();
        });
  }

  void
  addCylinder(const CylinderPatch& cylinder)
  {
    constexpr double two_pi = 2 * half_turn;
    const Vector3d low = cylinder.axis_point + cylinder.low * cylinder.axis_direction,
                   high = cylinder.axis_point + cylinder.high * cylinder.axis_direction;
    if (!(std::abs(cylinder.axis_direction.dot(plan_.up)) > level_cosine) ||
        !low.allFinite() || !high.allFinite() || !(cylinder.radius > 0))
      return;
    const auto [bottom, top] = std::minmax({plan_.heightOf(low), plan_.heightOf(high)});
    const double cut = plan_.cut - plan_.floor;
    const Vector2d middle = plan_.placeOf(cylinder.axis_u);
    if (bottom <= cut && top >= cut) {
      const double arc = std::min(cylinder.arc, two_pi);
      const double begin = std::atan2(middle.y(), middle.x()) - arc / 2;
      const Vector2d center = plan_.placeOf(
          low + (cut - plan_.heightOf(low)) /
                    (plan_.heightOf(high) - plan_.heightOf(low)) * (high - low));
      plan_.columns.push_back(
          {center, cylinder.radius, begin, begin + arc, cylinder.is_hollow});
    }
    else if (top > lowest_furniture && top < cut && !cylinder.is_hollow)
      addRound(plan_.placeOf(low), cylinder.radius, top);
  }

  void
  addRound(const Vector2d& center, double radius, double top)
  {
    constexpr int corners = 32;
    constexpr double two_pi = 2 * half_turn;
    PlanFurniture round{{}, top};
    for (int k = 0; k < corners; ++k)
      round.outline.push_back(center +
                              radius * Vector2d(std::cos(two_pi * k / corners),
                                                std::sin(two_pi * k / corners)));
    plan_.furniture.push_back(std::move(round));
  }

  const CompactMap& map_;
  FloorPlan& plan_;
  double walls_top_ = 0;              ///< above the floor, metres
  std::set<std::int32_t> box_planes_; ///< with sides of boxes
  std::set<std::int32_t> box_sides_;  ///< of these, those that are no larger
  std::set<std::int32_t> leaves_;     ///< planes
};

} // namespace

void
addContents(const CompactMap& map, FloorPlan& plan)
{
  ContentsFinder(map, plan).find();
}

} // namespace pcl::acmap
