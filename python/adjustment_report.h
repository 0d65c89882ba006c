#pragma once

#include <pcl/mapping/plane_adjustment_types.h>

#include <pybind11/pybind11.h>

namespace pcl::acmap::python {

/** \brief Converts the report of a plane adjustment to a Python object. */
pybind11::object
reportOfAdjustment(const PlaneAdjustmentReport& report);

} // namespace pcl::acmap::python
