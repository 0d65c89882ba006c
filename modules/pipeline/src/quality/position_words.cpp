#include "quality/position_words.h"

#include "quality/plan_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;

std::string
metres(double length)
{
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.1f m", length);
  return text.data();
}

/** \brief "Top of furniture in room 1" as "the top of furniture in room 1". */
std::string
withArticle(std::string name)
{
  if (!name.empty() && name[0] >= 'A' && name[0] <= 'Z')
    name[0] = static_cast<char>(name[0] - 'A' + 'a');
  return "the " + name;
}

std::string
roomName(const CompactMap& map, std::int32_t room)
{
  const auto index = static_cast<std::size_t>(room);
  if (room < 0 || index >= map.rooms.size() || map.rooms[index].label.name.empty())
    return "this room";
  std::string name = map.rooms[index].label.name;
  if (name.rfind("Room", 0) == 0)
    name[0] = 'r';
  return name;
}

/** \brief Where people stood: the middle of the path, or of the room. */
Vector2d
usualPlace(const CompactMap& map, const FloorPlan& plan, std::int32_t room)
{
  if (map.trajectory.poses.empty())
    return room >= 0 && static_cast<std::size_t>(room) < plan.rooms.size()
               ? plan.rooms[static_cast<std::size_t>(room)].center
               : Vector2d::Zero();
  Vector2d sum = Vector2d::Zero();
  for (const Eigen::Isometry3d& pose : map.trajectory.poses)
    sum += plan.placeOf(pose.translation());
  return sum / static_cast<double>(map.trajectory.poses.size());
}

/** \brief "1.2 m to the left", or nothing if it is less than 0.4 m. */
std::string
sideText(double left)
{
  constexpr double min_side = 0.4; // metres
  return std::abs(left) < min_side ? ""
                                   : ", " + metres(std::abs(left)) + " to the " +
                                         (left > 0 ? "left" : "right");
}

/** \brief "Behind the furniture, 1.2 m to the left": as seen from where people stood. */
std::string
besideFurniture(const Vector2d& place, const Vector2d& usual, const FloorPlan& plan)
{
  constexpr double near = 1.5, clear = 0.3; // metres
  const PlanFurniture* nearest = nullptr;
  double distance = near;
  for (const PlanFurniture& one : plan.furniture)
    if (const double its = distanceToLoop(one.outline, place); its < distance) {
      nearest = &one;
      distance = its;
    }
  if (!nearest)
    return "";
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& corner : nearest->outline)
    middle += corner / static_cast<double>(nearest->outline.size());
  if ((middle - usual).norm() < clear)
    return "";
  const Vector2d ahead = (middle - usual).normalized(), arm = place - middle;
  const double along = ahead.dot(arm);
  // x right and y ahead, seen from above with the up direction towards the viewer
  const double turn = plan.x_axis.cross(plan.y_axis).dot(plan.up) > 0 ? 1 : -1;
  const double left = turn * (ahead.x() * arm.y() - ahead.y() * arm.x());
  const std::string name = nearest->top < 1.1 ? "the table" : "the cupboard";
  if (std::abs(along) < clear)
    return (left > 0 ? "Left of " : "Right of ") + name;
  return (along > 0 ? "Behind " : "In front of ") + name + sideText(left);
}

/** \brief "1.1 m from the wall of room 2" */
std::string
fromWall(const NextPosition& position, const CompactMap& map, const FloorPlan& plan)
{
  const Vector2d place = plan.placeOf(position.eye);
  const PlanWall* nearest = nullptr;
  double distance = std::numeric_limits<double>::infinity();
  for (const PlanWall& wall : plan.walls)
    if (const double its = distanceToSegment(wall.from, wall.to, place);
        its < distance) {
      nearest = &wall;
      distance = its;
    }
  if (!nearest || nearest->plane >= map.planes.size() ||
      map.planes[nearest->plane].label.name.empty())
    return "";
  return ", " + metres(distance) + " from " +
         withArticle(map.planes[nearest->plane].label.name) + " (plane " +
         std::to_string(nearest->plane) + ")";
}

/** \brief "1.2 m from the door", for the nearest opening within 2 m. */
std::string
fromOpening(const Vector2d& place, const CompactMap& map, const FloorPlan& plan)
{
  constexpr double near = 2; // metres
  const MapOpening* nearest = nullptr;
  double distance = near;
  for (const MapOpening& opening : map.openings)
    if (const double its = distanceToSegment(
            plan.placeOf(opening.from), plan.placeOf(opening.to), place);
        its < distance) {
      nearest = &opening;
      distance = its;
    }
  if (!nearest || nearest->label.name.empty())
    return "";
  return ", " + metres(distance) + " from " + withArticle(nearest->label.name);
}

/** \brief What is unseen there. */
std::string
lookText(const Eigen::Vector3d& looked_at,
         SurfaceRole role,
         const CompactMap& map,
         const NextPosition& position)
{
  const std::string where = " of " + roomName(map, position.room);
  if (role == SurfaceRole::Floor)
    return "look down at the floor" + where;
  if (role == SurfaceRole::Ceiling)
    return "look up at the ceiling" + where;
  constexpr double near = 0.5; // metres
  std::optional<std::size_t> wall;
  double distance = near;
  for (std::size_t plane = 0; plane < map.planes.size(); ++plane)
    if (const PlanePatch& one = map.planes[plane]; one.label.role == SurfaceRole::Wall)
      if (const double its = std::abs(one.coefficients.dot(looked_at.homogeneous()));
          its < distance) {
        wall = plane;
        distance = its;
      }
  return wall ? "look along " + withArticle(map.planes[*wall].label.name) + " (plane " +
                    std::to_string(*wall) + ")"
              : "look where " + roomName(map, position.room) + " is open";
}

} // namespace

std::string
wordsOf(const NextPosition& position,
        const Eigen::Vector3d& looked_at,
        SurfaceRole role,
        const CompactMap& map,
        const FloorPlan& plan)
{
  const Vector2d place = plan.placeOf(position.eye);
  const std::string furniture =
      besideFurniture(place, usualPlace(map, plan, position.room), plan);
  std::string words = furniture.empty()
                          ? "In " + roomName(map, position.room)
                          : furniture + " in " + roomName(map, position.room);
  const std::string opening = fromOpening(place, map, plan);
  if (furniture.empty())
    words += opening.empty() ? fromWall(position, map, plan) : opening;
  return words + "; " + lookText(looked_at, role, map, position);
}

} // namespace pcl::acmap
