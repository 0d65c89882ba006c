#pragma once

#include "x_connection.h"

#include <pcl/acquisition/pattern_window.h>

namespace pcl::acmap {

/** \brief The active monitors in the server's order; if the server cannot list them,
 * the whole screen as one monitor. \throws IOException when the display fails */
std::vector<MonitorPlace>
findMonitors(XConnection& connection);

/** \throws BadArgumentException when there is no such monitor */
MonitorPlace
chooseMonitor(XConnection& connection, std::size_t index);

} // namespace pcl::acmap
