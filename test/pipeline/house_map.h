#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/pipeline/surface_names.h>
#include <pcl/texture/floor_plan.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace pcl::acmap::test {

using Eigen::Vector2d;
using Eigen::Vector3d;

using Loop = std::vector<Vector3d>;

/** Adds a plane with a polygon, z up, whose normal is that of its corners. */
inline void
addPlane(CompactMap& map, const Loop& outer, const std::vector<Loop>& holes = {})
{
  PlanePatch plane;
  Vector3d twice = Vector3d::Zero(), sum = Vector3d::Zero();
  for (std::size_t k = 0; k < outer.size(); ++k) {
    twice += outer[k].cross(outer[(k + 1) % outer.size()]);
    sum += outer[k];
  }
  const Vector3d normal = twice.normalized();
  plane.center = sum / static_cast<double>(outer.size());
  plane.coefficients << normal, -normal.dot(plane.center);
  plane.axis_u = normal.unitOrthogonal();
  plane.axis_v = normal.cross(plane.axis_u);
  plane.area = twice.norm() / 2;
  plane.rms = 0.0068;
  const auto floats = [](const Loop& loop) {
    std::vector<Eigen::Vector3f> result;
    for (const Vector3d& place : loop)
      result.emplace_back(place.cast<float>());
    return result;
  };
  PlanePolygon polygon{floats(outer), {}};
  for (const Loop& hole : holes)
    polygon.holes.push_back(floats(hole));
  plane.polygons.push_back(polygon);
  map.planes.push_back(plane);
}

/** A wall from one place to another, seen from the left, between two heights. */
inline Loop
upright(const Vector2d& from, const Vector2d& to, double low, double high)
{
  return {{from.x(), from.y(), low},
          {from.x(), from.y(), high},
          {to.x(), to.y(), high},
          {to.x(), to.y(), low}};
}

inline Loop
level(const Vector2d& least, const Vector2d& most, double height, bool up)
{
  Loop loop{{least.x(), least.y(), height},
            {most.x(), least.y(), height},
            {most.x(), most.y(), height},
            {least.x(), most.y(), height}};
  if (!up)
    std::reverse(loop.begin(), loop.end());
  return loop;
}

/** Two rooms of 5 x 4 m and 3 x 4 m, 2.6 m high, joined by a door of 0.9 x 2 m in a wall of
 * 0.1 m, with a window of 1.2 x 1 m, a table, a cupboard, and the leaf of the door. */
inline CompactMap
makeHouse()
{
  CompactMap map;
  map.up = Vector3d::UnitZ();
  constexpr double high = 2.6;
  addPlane(map, level({0, 0}, {8.1, 4}, 0, true));     // 0, floor
  addPlane(map, level({0, 0}, {8.1, 4}, high, false)); // 1, ceiling
  addPlane(map, upright({0, 4}, {0, 0}, 0, high));     // 2
  addPlane(map, upright({0, 0}, {8.1, 0}, 0, high));   // 3
  addPlane(map, upright({8.1, 0}, {8.1, 4}, 0, high)); // 4
  addPlane(map,
           upright({8.1, 4}, {0, 4}, 0, high), // 5, with the window
           {{{3, 4, 1}, {1.8, 4, 1}, {1.8, 4, 2}, {3, 4, 2}}});
  const auto partition = [&](double x, bool back) {
    Loop loop{{x, 0, 0},
              {x, 0, high},
              {x, 4, high},
              {x, 4, 0},
              {x, 2.4, 0},
              {x, 2.4, 2},
              {x, 1.5, 2},
              {x, 1.5, 0}};
    if (back)
      std::reverse(loop.begin(), loop.end());
    return loop;
  };
  addPlane(map, partition(5, false));                           // 6
  addPlane(map, partition(5.1, true));                          // 7
  addPlane(map, level({2, 1.5}, {3.6, 2.3}, 0.74, true));       // 8, table
  addPlane(map, upright({2, 1.5}, {3.6, 1.5}, 0.1, 0.74));      // 9, its side
  addPlane(map, level({2, 1.5}, {3.6, 2.3}, 0.7, false));       // 10, from below
  addPlane(map, upright({0.45, 3.2}, {0.45, 2}, 0, 1.95));      // 11, cupboard
  addPlane(map, upright({5.12, 2.4}, {5.95, 2.4}, 0.02, 1.98)); // 12, door leaf
  addPlane(map, upright({8.1, 4}, {7.6, 4}, 0.1, 0.6));         // 13, on the wall
  return map;
}

inline CompactMap
named(CompactMap map)
{
  const FloorPlan plan = makeFloorPlan(map);
  setRooms(plan, map);
  nameSurfaces(plan, map);
  return map;
}

} // namespace pcl::acmap::test
