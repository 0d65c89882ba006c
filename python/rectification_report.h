#pragma once

#include <pcl/mapping/entropy_rectification_types.h>

#include <pybind11/pybind11.h>

namespace pcl::acmap::python {

/** \brief The report of a rectification as a Python object. */
pybind11::object
reportOfRectification(EntropyRectificationReport&& report);

} // namespace pcl::acmap::python
