#pragma once

#include <Eigen/Core>

#include <string>

namespace pcl::acmap {

/** \brief A number with that many decimals, with a point in every locale. */
std::string
fixed(double value, int decimals);

/** \brief The angle of a text along a direction, so that it is read from below or from the
 * right; radians from the x axis. */
double
readableAngle(const Eigen::Vector2d& along);

/** \brief Square metres with one decimal, without unit. */
std::string
areaText(double area);

} // namespace pcl::acmap
