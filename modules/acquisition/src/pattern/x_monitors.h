#pragma once

#include "x_connection.h"

#include <pcl/acquisition/pattern_window.h>

namespace pcl::acmap {

/** \brief The monitors in use, in the server's order; all of the screen as one where it
 * cannot tell. \throws IOException when the display fails */
std::vector<MonitorPlace>
findMonitors(XConnection& connection);

/** \throws BadArgumentException when there is no such monitor */
MonitorPlace
chooseMonitor(XConnection& connection, std::size_t index);

} // namespace pcl::acmap
