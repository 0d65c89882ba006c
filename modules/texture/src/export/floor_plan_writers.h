#pragma once

#include <pcl/texture/floor_plan.h>

#include <Eigen/Geometry>

#include <string>

namespace pcl::acmap {

/** \brief The smallest box of a plan, not empty. */
Eigen::AlignedBox2d
boxOf(const FloorPlan& plan);

/** \brief The horizontal axis of the map that the plan's north arrow shows. */
struct PlanNorth {
  Eigen::Vector2d direction = Eigen::Vector2d::UnitY(); ///< in the plan, length 1
  const char* axis = "z";                               ///< its name in the map
};

/** \brief z, the direction in which the first camera looked, or y where z is up. */
PlanNorth
northOf(const FloorPlan& plan);

/** \brief What is to be added to a place of the plan for coordinates of the input. */
inline Eigen::Vector2d
offsetOf(const FloorPlan& plan)
{
  return {plan.shift.dot(plan.x_axis), plan.shift.dot(plan.y_axis)};
}

/** \brief Square metres with one decimal, without unit. */
std::string
areaText(double area);

/** \brief The plan as SVG 1.1, 1 : 100. */
std::string
svgOf(const FloorPlan& plan);

/** \brief The plan as ASCII DXF of release 12, metres, one layer per kind. */
std::string
dxfOf(const FloorPlan& plan);

/** \brief The plan as GeoJSON, metres in the frame of the plan. */
std::string
geoJsonOf(const FloorPlan& plan);

} // namespace pcl::acmap
