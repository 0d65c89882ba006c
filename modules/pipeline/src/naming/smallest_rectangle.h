#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief Sides of the smallest rectangle around points, the longer one first; zero without
 * points. */
Eigen::Vector2d
sidesOfSmallestRectangle(std::vector<Eigen::Vector2d> points);

} // namespace pcl::acmap
