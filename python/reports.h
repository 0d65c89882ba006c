#pragma once

#include <pcl/core/report.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace pcl::acmap::python {

/** \brief Converts a report to a Python object with fields of the same names, which can
 * be printed.
 * \param[in] fields of the stage; `seconds` and `remarks` are added */
inline pybind11::object
reportOf(pybind11::dict fields, const Report& report)
{
  fields["seconds"] = report.seconds;
  fields["remarks"] = report.remarks;
  return pybind11::module_::import("types").attr("SimpleNamespace")(**fields);
}

} // namespace pcl::acmap::python
