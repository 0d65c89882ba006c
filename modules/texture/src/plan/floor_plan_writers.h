#pragma once

#include "plan/plan_drawing.h"

#include <pcl/texture/floor_plan.h>

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Corners of all that is in a plan. */
std::vector<Eigen::Vector2d>
pointsOf(const FloorPlan& plan);

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

/** \brief A drawing as SVG 1.1, in millimetres of the paper. */
std::string
svgOf(const PlanDrawing& drawing);

/** \brief A drawing as ASCII DXF of release 12, metres, one layer per kind.
 * \param[in] offset is added to all places */
std::string
dxfOf(const PlanDrawing& drawing, const Eigen::Vector2d& offset);

/** \brief The plan as GeoJSON, metres in the frame of the plan. */
std::string
geoJsonOf(const FloorPlan& plan);

} // namespace pcl::acmap
