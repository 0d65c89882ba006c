#pragma once

#include "clouds.h"

#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A cloud of finite points with its spacing. */
struct FigureCloud {
  std::string name;
  test::Cloud cloud;
  double spacing = 0; ///< median distance to the nearest different position, metres
};

/** \brief The clouds of the table of faults; missing ones are reported on stderr and
 * skipped. */
std::vector<FigureCloud>
realClouds();

/** \brief The single views of the time table: real ones and a simulated one. */
std::vector<FigureCloud>
singleViews();

} // namespace pcl::acmap::bench
