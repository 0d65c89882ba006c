#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/texture/compact_map_folder.h>
#include <pcl/texture/map_page.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector3d;

/** Adds a rectangle of one colour.
 * \param[in] u,v its sides from a corner, metres; their cross product is the normal */
void
addRectangle(CompactMap& map,
             const Vector3d& corner,
             const Vector3d& u,
             const Vector3d& v)
{
  PlanePatch plane;
  const Vector3d normal = u.cross(v).normalized();
  plane.coefficients << normal, -normal.dot(corner);
  plane.center = corner + (u + v) / 2;
  plane.axis_u = u.normalized();
  plane.axis_v = normal.cross(plane.axis_u);
  plane.area = u.cross(v).norm();
  plane.rms = 0.0068;
  plane.support = 1000;
  plane.polygons.resize(1);
  for (const Vector3d& point :
       {corner, Vector3d(corner + u), Vector3d(corner + u + v), Vector3d(corner + v)})
    plane.polygons[0].outer.push_back(point.cast<float>());
  TextureChart chart;
  chart.plane = map.planes.size();
  chart.origin = corner;
  chart.colors.width = static_cast<std::int32_t>(std::lround(u.norm() / 0.1));
  chart.colors.height = static_cast<std::int32_t>(std::lround(v.norm() / 0.1));
  chart.texel_u = u / chart.colors.width;
  chart.texel_v = v / chart.colors.height;
  const std::int32_t texels = chart.colors.width * chart.colors.height;
  for (std::int32_t i = 0; i < texels; ++i)
    for (const int level : {180, 60, 45})
      chart.colors.values.push_back(static_cast<std::uint8_t>(level));
  chart.kinds.assign(static_cast<std::size_t>(texels), TexelKind::Seen);
  map.planes.push_back(plane);
  map.charts.push_back(chart);
}

/** Six faces of 5 x 2.5 x 4 m; y points down. */
CompactMap
makeEmptyRoom()
{
  CompactMap map;
  map.up = -Vector3d::UnitY();
  const Vector3d x(5, 0, 0), y(0, 2.5, 0), z(0, 0, 4), low(-2.5, -1, -2);
  addRectangle(map, low + y, x, z); // 0: the floor
  addRectangle(map, low, z, x);     // 1: the ceiling
  addRectangle(map, low + z, y, x); // 2 to 5: walls
  addRectangle(map, low + x, z, y);
  addRectangle(map, low, x, y);
  addRectangle(map, low, y, z);
  return map;
}

/** The room that page/check.mjs knows, with a table, a board that is 2 degrees off parallel
 * to a wall, a piece in the air, a door, and a part of the floor that nobody saw. */
CompactMap
makeRoom()
{
  CompactMap map = makeEmptyRoom();
  addRectangle(map, {-2.5, 0.8, 0}, {1, 0, 0}, {0, 0, 1}); // 6: the table
  const double angle = 2 * std::acos(-1) / 180;
  const Vector3d along(std::cos(angle), 0, std::sin(angle));
  addRectangle(
      map, Vector3d(0.5, 0.5, -1) - along / 2, along, {0, 1, 0}); // 7: the board
  addRectangle(map, {0.2, 0.2, 0.5}, {0.3, 0, 0}, {0, 0, 0.3});
  for (std::size_t row = 0; row < 10; ++row)
    for (std::size_t column = 0; column < 10; ++column) {
      const std::size_t texel = 50 * row + column;
      map.charts[0].kinds[texel] = TexelKind::None;
      for (std::size_t k = 0; k < 3; ++k)
        map.charts[0].colors.values[3 * texel + k] = unknown_grey;
    }
  MapOpening door;
  door.from = {2.5, 1.5, -0.45};
  door.to = {2.5, 1.5, 0.45};
  door.top = 2;
  door.planes = {3, -1};
  door.rooms = {0, -1};
  MapRoom room;
  room.center = {0, 1.5, 0};
  room.area = 20;
  room.seen_area = 19;
  room.planes = {0, 1, 2, 3, 4, 5};
  room.openings = {0};
  map.openings = {door};
  map.rooms = {room};
  map.trajectory.stamps = {0, 1};
  map.trajectory.poses.assign(2, Eigen::Isometry3d::Identity());
  map.trajectory.poses[1].translation().x() = 0.5;
  return map;
}

/** What page/check.mjs does and finds there is told by what it prints. */
TEST(MapPageInABrowser, IsUsedByAPerson)
{
  constexpr const char *chromium = "/usr/bin/chromium", *node = "/usr/bin/node";
  if (!hasMapPage())
    GTEST_SKIP() << "acmap was built without the modules of its page";
  for (const char* program : {chromium, node})
    if (!std::filesystem::exists(program))
      GTEST_SKIP() << "there is no " << program;
  const TemporaryFolder folder;
  CompactMap map = makeRoom();
  saveCompactMap(folder.path("map"), map);
  saveMapPage(folder.path("map.html"), folder.path("map"), map.trajectory);
  CompactMap bare = makeEmptyRoom();
  saveCompactMap(folder.path("bare"), bare);
  saveMapPage(folder.path("bare.html"), folder.path("bare"));
  CompactMap colourless = makeEmptyRoom();
  for (TextureChart& chart : colourless.charts)
    std::fill(chart.kinds.begin(), chart.kinds.end(), TexelKind::None);
  saveCompactMap(folder.path("colourless"), colourless);
  saveMapPage(folder.path("colourless.html"), folder.path("colourless"));
  RunSettings settings;
  settings.time_limit = 900;
  const ToolRun run =
      runTool(node, {ACMAP_PAGE_CHECK, chromium, folder.path("")}, settings);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
}

} // namespace
} // namespace pcl::acmap::test
