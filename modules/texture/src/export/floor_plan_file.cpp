#include "export/floor_plan_writers.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/output_file.h>

#include <cmath>
#include <filesystem>
#include <locale>
#include <sstream>

namespace pcl {

namespace acmap {

Eigen::AlignedBox2d
boxOf(const FloorPlan& plan)
{
  Eigen::AlignedBox2d box;
  for (const auto& polygon : plan.floors)
    for (const auto& loop : polygon)
      for (const Eigen::Vector2d& place : loop)
        box.extend(place);
  for (const PlanWall& wall : plan.walls)
    box.extend(wall.from).extend(wall.to);
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

std::string
areaText(double area)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.setf(std::ios::fixed);
  text.precision(1);
  text << area;
  return text.str();
}

} // namespace acmap

void
saveFloorPlan(const std::string& path, const FloorPlan& plan)
{
  const std::string ending = std::filesystem::path(path).extension().string();
  std::string text;
  if (ending == ".svg")
    text = acmap::svgOf(plan);
  else if (ending == ".dxf")
    text = acmap::dxfOf(plan);
  else if (ending == ".geojson")
    text = acmap::geoJsonOf(plan);
  else
    throw acmap::BadArgument(path +
                             ": a floor plan is written as .svg, .dxf or .geojson");
  acmap::OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

} // namespace pcl
