#pragma once

#include <pcl/core/report.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace pcl::acmap::python {

/** \brief A Python object with these fields, which can be printed. */
inline pybind11::object
namespaceOf(const pybind11::dict& fields)
{
  return pybind11::module_::import("types").attr("SimpleNamespace")(**fields);
}

/** \brief Converts a report to a Python object with fields of the same names, which can
 * be printed.
 * \param[in] fields of the stage; `seconds` and `remarks` are added */
inline pybind11::object
reportOf(pybind11::dict fields, const Report& report)
{
  fields["seconds"] = report.seconds;
  fields["remarks"] = report.remarks;
  return namespaceOf(fields);
}

/** \brief The fields that a report names. */
template <typename StageReport>
pybind11::dict
fieldsOf(const StageReport& report)
{
  pybind11::dict fields;
  visitFields(report,
              [&fields](const char* name, const auto& value) { fields[name] = value; });
  return fields;
}

/** \brief The same for a report that names its fields. */
template <typename StageReport>
pybind11::object
reportOf(const StageReport& report)
{
  return reportOf(fieldsOf(report), report);
}

} // namespace pcl::acmap::python
