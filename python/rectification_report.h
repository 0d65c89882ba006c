#pragma once

#include <pcl/mapping/entropy_rectification_types.h>

#include <pybind11/pybind11.h>

namespace pcl::acmap::python {

/** \brief Converts the report of a rectification to a Python object. */
pybind11::object
reportOfRectification(EntropyRectificationReport&& report);

} // namespace pcl::acmap::python
