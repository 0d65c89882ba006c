#pragma once

#include "plan/drawn_openings.h"
#include "plan/plan_drawing.h"
#include "plan/text_places.h"

#include <Eigen/Geometry>

#include <vector>

namespace pcl::acmap {

/** \brief Distance from the walls to the outer edge of the chains, millimetres of the
 * paper. */
inline constexpr double dimension_band = 24;

/** \brief Adds chains of dimensions on all sides of a building: from end to end, and between
 * the walls and openings that are next to the side. They are between seen faces of walls.
 * \param[in] x_axis direction of most walls, unit length; the chains are along it and across
 * \param[in] contents places that the chains are outside of
 * \param[in,out] places of texts so far */
void
addDimensions(const FloorPlan& plan,
              const std::vector<DrawnOpening>& openings,
              const Eigen::Vector2d& x_axis,
              const std::vector<Eigen::Vector2d>& contents,
              PlanDrawing& drawing,
              TextPlaces& places);

} // namespace pcl::acmap
