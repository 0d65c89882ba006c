#pragma once

#include <pcl/acquisition/pattern_window.h>

#include <vector>

namespace pcl::acmap::test {

/** \brief Takes a screenshot of the display of the environment. */
RgbImage
shootScreen();

/** \brief Divides the screen into monitors; the first one gets the output of the
 * server. */
void
divideScreen(const std::vector<MonitorPlace>& monitors);

} // namespace pcl::acmap::test
