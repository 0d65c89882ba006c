#pragma once

#include <pcl/pipeline/compact_mapping_types.h>

#include <pybind11/pybind11.h>

namespace pcl::acmap::python {

/** \brief Converts the report of a mapping to a Python object: a part for each step. */
pybind11::object
reportOfMapping(const CompactMappingReport& report);

} // namespace pcl::acmap::python
