#pragma once

#include "shown.h"

#include <pcl/core/compact_map.h>

namespace pcl::acmap::python {

/** \brief A compact map with the report of the run that made it, None for a map from a
 * folder. */
struct ReportedMap {
  CompactMap map;
  ReportOrNone report;
};

} // namespace pcl::acmap::python
