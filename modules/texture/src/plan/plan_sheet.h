#pragma once

#include "plan/plan_drawing.h"

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Chooses scale and sheet for what is to be drawn.
 * \param[in] box of the building, metres
 * \param[in] band around it for dimensions, millimetres of the paper */
void
chooseSheet(const Eigen::AlignedBox2d& box, double band, PlanDrawing& drawing);

/** \brief Adds frame, legend, scale bar and title below the plan.
 * \param[in] axis direction in the plan of a horizontal axis of the map, unit length
 * \param[in] axis_name its name
 * \param[in] notes lines below the title */
void
addTitleBlock(const Eigen::Vector2d& axis,
              const std::string& axis_name,
              const std::vector<std::string>& notes,
              PlanDrawing& drawing);

} // namespace pcl::acmap
