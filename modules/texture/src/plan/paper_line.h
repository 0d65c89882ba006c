#pragma once

#include "plan/plan_drawing.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief Lengths of the dashes of a pen and of the gaps between them, millimetres. */
inline constexpr double dash_length = 1.6, dash_gap = 1;

/** \brief A part of a circle as a line, whose corners are within some micrometres of it on
 * the paper. */
PlanLine
lineOf(const PlanArc& arc);

/** \brief The dashes of a line, or the line itself; a closed one ends where it begins. */
std::vector<std::vector<Eigen::Vector2d>>
piecesOf(const PlanLine& line, double scale);

} // namespace pcl::acmap
