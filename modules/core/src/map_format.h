#pragma once

#include <pcl/core/compact_map.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief What is wrong with the equation of a plane, to follow the name of its
 * coefficients; empty for nothing. */
std::string
faultOfCoefficients(const Eigen::Vector4d& coefficients);

/** \brief The same of a loop of a polygon. */
std::string
faultOfLoop(const std::vector<Eigen::Vector3f>& loop);

/** \brief The same of the texels of all charts so far, to follow the name of the last. */
std::string
faultOfTexels(std::int64_t texels);

/** \brief The same of the name of a chart's image; an empty one is none. */
std::string
faultOfImageName(const std::string& name);

/** \brief Lets maps pass that a map file can hold: those that the reader takes.
 * \throws BadArgumentException when planes, charts, observations or poses make no sense */
void
requireConsistent(const CompactMap& map);

} // namespace pcl::acmap
