#include "plan/floor_plan_writers.h"
#include "plan/paper_line.h"
#include "plan/plan_raster.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/output_file.h>

#include <cmath>
#include <filesystem>

namespace pcl {

namespace acmap {

std::vector<Eigen::Vector2d>
pointsOf(const FloorPlan& plan)
{
  std::vector<Eigen::Vector2d> points;
  for (const auto& polygon : plan.floors)
    for (const auto& loop : polygon)
      points.insert(points.end(), loop.begin(), loop.end());
  for (const auto* walls : {&plan.walls, &plan.unseen_walls})
    for (const PlanWall& wall : *walls) {
      points.push_back(wall.from);
      points.push_back(wall.to);
    }
  for (const PlanFurniture& one : plan.furniture)
    points.insert(points.end(), one.outline.begin(), one.outline.end());
  for (const PlanColumn& column : plan.columns) {
    const PlanLine line = lineOf(
        PlanArc{column.center, column.radius, column.begin, column.end, PlanPen{}});
    points.insert(points.end(), line.points.begin(), line.points.end());
  }
  return points;
}

Eigen::AlignedBox2d
boxOf(const FloorPlan& plan)
{
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : pointsOf(plan))
    box.extend(point);
  if (box.isEmpty())
    box.extend(Eigen::Vector2d::Zero());
  return box;
}

PlanNorth
northOf(const FloorPlan& plan)
{
  const auto across = [&](const Eigen::Vector3d& axis) {
    return Eigen::Vector2d(axis.dot(plan.x_axis), axis.dot(plan.y_axis));
  };
  const Eigen::Vector2d y = across(Eigen::Vector3d::UnitY()),
                        z = across(Eigen::Vector3d::UnitZ());
  return z.norm() >= y.norm() ? PlanNorth{z.normalized(), "z"}
                              : PlanNorth{y.normalized(), "y"};
}

} // namespace acmap

void
saveFloorPlan(const std::string& path, const FloorPlan& plan)
{
  constexpr double resolution = 6; // pixels for a millimetre of the paper
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".png") {
    savePng(path, acmap::rasterOf(acmap::drawPlan(plan), resolution));
    return;
  }
  std::string text;
  if (ending == ".svg")
    text = acmap::svgOf(acmap::drawPlan(plan));
  else if (ending == ".dxf")
    text = acmap::dxfOf(acmap::drawPlan(plan), acmap::offsetOf(plan));
  else if (ending == ".geojson")
    text = acmap::geoJsonOf(plan);
  else
    throw acmap::BadArgument(
        path + ": a floor plan is written as .svg, .png, .dxf or .geojson");
  acmap::OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

} // namespace pcl
