#include "report/map_details.h"

#include <pcl/core/fields.h>
#include <pcl/core/map_up.h>
#include <pcl/core/surface_sentence.h>
#include <pcl/pipeline/unseen_surfaces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <tuple>
#include <vector>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

Json
listOfPlanes(const CompactMap& map)
{
  Json list = Json::array();
  for (std::size_t id = 0; id < map.planes.size(); ++id) {
    const PlanePatch& plane = map.planes[id];
    const Eigen::Vector4d& n = plane.coefficients;
    list.push_back({{"id", id},
                    {"name", plane.label.name},
                    {"role", nameIn(surface_role_names, plane.label.role)},
                    {"size", {plane.label.size.x(), plane.label.size.y()}},
                    {"description", describePlane(map, id)},
                    {"coefficients", {n[0], n[1], n[2], n[3]}},
                    {"area", plane.area},
                    {"rmse", plane.rms},
                    {"support", plane.support}});
  }
  return list;
}

Json
listOfRooms(const CompactMap& map)
{
  Json list = Json::array();
  for (std::size_t id = 0; id < map.rooms.size(); ++id) {
    const MapRoom& room = map.rooms[id];
    list.push_back({{"name", room.label.name},
                    {"description", describeRoom(map, id)},
                    {"area", room.area},
                    {"size", {room.label.size.x(), room.label.size.y()}}});
  }
  return list;
}

/** The number of openings of each kind that there is; null if there are none. */
Json
countsOfOpenings(const CompactMap& map)
{
  Json counts;
  for (const MapOpening& opening : map.openings) {
    Json& count = counts[opening_kind_names[static_cast<std::size_t>(opening.kind)]];
    count = count.is_null() ? 1 : count.get<int>() + 1;
  }
  return counts;
}

Json
listOfCylinders(const std::vector<CylinderPatch>& cylinders)
{
  Json list = Json::array();
  for (std::size_t id = 0; id < cylinders.size(); ++id) {
    const CylinderPatch& cylinder = cylinders[id];
    list.push_back({{"id", id},
                    {"radius", cylinder.radius},
                    {"length", cylinder.high - cylinder.low},
                    {"arc", cylinder.arc},
                    {"hollow", cylinder.is_hollow},
                    {"area", cylinder.area},
                    {"rmse", cylinder.rms},
                    {"support", cylinder.support},
                    {"saved_bits", cylinder.saved_bits}});
  }
  return list;
}

/** Boxes or recesses. */
template <typename Patch>
Json
listOfSizes(const std::vector<Patch>& patches)
{
  Json list = Json::array();
  for (std::size_t id = 0; id < patches.size(); ++id) {
    const Patch& patch = patches[id];
    list.push_back({{"id", id},
                    {"size", {patch.size[0], patch.size[1], patch.size[2]}},
                    {"template", patch.template_id},
                    {"saved_bits", patch.saved_bits}});
  }
  return list;
}

Json
jsonOfVector(const Eigen::Vector3d& vector)
{
  return {vector.x(), vector.y(), vector.z()};
}

/** Rounded to a centimetre. */
double
centimetresOf(double length)
{
  return std::round(100 * length) / 100;
}

Json
outlineOf(const std::vector<Eigen::Vector2d>& outline)
{
  Json list = Json::array();
  for (const Eigen::Vector2d& corner : outline)
    list.push_back({centimetresOf(corner.x()), centimetresOf(corner.y())});
  return list;
}

Json
lineOf(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  return {centimetresOf(from.x()),
          centimetresOf(from.y()),
          centimetresOf(to.x()),
          centimetresOf(to.y())};
}

/** Where something is unseen, once for each place and role. */
Json
listOfUnseen(const UnseenSurfaces& unseen, const FloorPlan& plan)
{
  Json list = Json::array();
  std::set<std::tuple<double, double, SurfaceRole>> told;
  for (const UnseenPatch& patch : unseen.patches) {
    const double x = centimetresOf(patch.center.dot(plan.x_axis)),
                 y = centimetresOf(patch.center.dot(plan.y_axis));
    if (told.emplace(x, y, patch.role).second)
      list.push_back({x, y, nameIn(surface_role_names, patch.role)});
  }
  return list;
}

} // namespace

Json
detailsOfMap(const CompactMap& map)
{
  constexpr double degrees = 180 / 3.14159265358979323846;
  const Eigen::Vector3d up = upDirection(map);
  Json details = {{"planes", listOfPlanes(map)}, {"rooms", listOfRooms(map)}};
  if (const Json openings = countsOfOpenings(map); !openings.is_null())
    details["openings"] = openings;
  details["cylinders"] = listOfCylinders(map.cylinders);
  details["boxes"] = listOfSizes(map.boxes);
  details["recesses"] = listOfSizes(map.recesses);
  details["up"] = jsonOfVector(up);
  details["tilt_deg"] = degrees * std::acos(std::min(1.0, up.dot(upAxis(map))));
  if (!map.shift.isZero(0))
    details["shift"] = jsonOfVector(map.shift);
  return details;
}

Json
detailsOfPlan(const CompactMap& map, const FloorPlan& plan)
{
  const UnseenSurfaces unseen = findUnseenSurfaces(map, plan);
  Json rooms = Json::array(), furniture = Json::array(), walls = Json::array(),
       openings = Json::array();
  for (const PlanRoom& room : plan.rooms)
    rooms.push_back(outlineOf(room.outline));
  for (const PlanFurniture& one : plan.furniture)
    furniture.push_back(outlineOf(one.outline));
  for (const PlanWall& wall : plan.walls) {
    walls.push_back(lineOf(wall.from, wall.to));
    walls.back().push_back(wall.plane);
  }
  for (const PlanOpening& opening : plan.openings)
    openings.push_back(lineOf(opening.from, opening.to));
  return {{"axes", {jsonOfVector(plan.x_axis), jsonOfVector(plan.y_axis)}},
          {"rooms", rooms},
          {"furniture", furniture},
          {"walls", walls},
          {"openings", openings},
          {"patch_size", unseen.patch_size},
          {"unseen", listOfUnseen(unseen, plan)}};
}

} // namespace pcl::acmap
