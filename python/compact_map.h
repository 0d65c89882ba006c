#pragma once

#include <pcl/core/compact_map.h>

#include <pybind11/pybind11.h>

namespace pcl::acmap::python {

/** \brief A compact map with the report of the run that made it, None for a map from a
 * folder. */
struct ReportedMap {
  CompactMap map;
  pybind11::object report;
};

} // namespace pcl::acmap::python
