#pragma once

#include "clouds.h"

#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A cloud of finite points with its spacing. */
struct FigureCloud {
  std::string name;
  test::Cloud cloud;
  double spacing = 0; ///< median to the nearest other place, metres
};

/** \brief The clouds of the list of faults; those that are not there are named on
 * stderr and left out. */
std::vector<FigureCloud>
realClouds();

/** \brief The single views of the time table: real ones and a simulated one. */
std::vector<FigureCloud>
singleViews();

} // namespace pcl::acmap::bench
