#pragma once

#include <pcl/acquisition/pattern_window.h>

#include <vector>

namespace pcl::acmap::test {

/** \brief What the display of the environment shows, all of it. */
RgbImage
shootScreen();

/** \brief Divides its screen among monitors: the first has the server's output. */
void
divideScreen(const std::vector<MonitorPlace>& monitors);

} // namespace pcl::acmap::test
