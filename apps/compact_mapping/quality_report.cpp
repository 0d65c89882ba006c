#include "quality_report.h"

#include "fields_json.h"

#include <pcl/pipeline/unseen_surfaces.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <tuple>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

/** \brief Rounded to a centimetre. */
double
rounded(double length)
{
  return std::round(100 * length) / 100;
}

Json
jsonOf(const std::vector<Eigen::Vector2d>& outline)
{
  Json list = Json::array();
  for (const Eigen::Vector2d& corner : outline)
    list.push_back({rounded(corner.x()), rounded(corner.y())});
  return list;
}

Json
jsonOf(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  return {rounded(from.x()), rounded(from.y()), rounded(to.x()), rounded(to.y())};
}

Json
vectorOf(const Eigen::Vector3d& vector)
{
  return {vector.x(), vector.y(), vector.z()};
}

/** \brief Where something is unseen, once for each place and role. */
Json
unseenOf(const UnseenSurfaces& unseen, const FloorPlan& plan)
{
  Json list = Json::array();
  std::set<std::tuple<double, double, SurfaceRole>> told;
  for (const UnseenPatch& patch : unseen.patches) {
    const double x = rounded(patch.center.dot(plan.x_axis)),
                 y = rounded(patch.center.dot(plan.y_axis));
    if (told.emplace(x, y, patch.role).second)
      list.push_back({x, y, nameIn(surface_role_names, patch.role)});
  }
  return list;
}

} // namespace

void
tellQuality(const CompactMappingReport& report, StageLog& log)
{
  if (report.quality) {
    log.details["quality"] = fieldsOf(*report.quality);
    log.tell("quality", describeQuality(*report.quality));
  }
  if (report.next_positions)
    log.details["next_positions"] = fieldsOf(*report.next_positions);
}

nlohmann::ordered_json
planOf(const CompactMap& map, const FloorPlan& plan)
{
  const UnseenSurfaces unseen = findUnseenSurfaces(map, plan);
  Json rooms = Json::array(), furniture = Json::array(), walls = Json::array(),
       openings = Json::array();
  for (const PlanRoom& room : plan.rooms)
    rooms.push_back(jsonOf(room.outline));
  for (const PlanFurniture& one : plan.furniture)
    furniture.push_back(jsonOf(one.outline));
  for (const PlanWall& wall : plan.walls) {
    walls.push_back(jsonOf(wall.from, wall.to));
    walls.back().push_back(wall.plane);
  }
  for (const PlanOpening& opening : plan.openings)
    openings.push_back(jsonOf(opening.from, opening.to));
  return {{"axes", {vectorOf(plan.x_axis), vectorOf(plan.y_axis)}},
          {"rooms", rooms},
          {"furniture", furniture},
          {"walls", walls},
          {"openings", openings},
          {"patch_size", unseen.patch_size},
          {"unseen", unseenOf(unseen, plan)}};
}

} // namespace pcl::acmap
