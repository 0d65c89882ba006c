#pragma once

#include "array_view.h"

#include <pcl/core/fields.h>
#include <pcl/core/report.h>

#include <Eigen/Geometry>

#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <type_traits>
#include <vector>

namespace pcl::acmap::python {

namespace py = pybind11;

/** \brief An acmap.Report with these fields. */
inline ReportObject
namespaceOf(const py::dict& fields)
{
  return py::module_::import("acmap").attr("Report")(**fields);
}

/** \brief Converts a report to an acmap.Report.
 * \param[in] fields of the stage; `seconds` and `remarks` are added */
inline ReportObject
reportOf(py::dict fields, const Report& report)
{
  fields["seconds"] = report.seconds;
  fields["remarks"] = report.remarks;
  return namespaceOf(fields);
}

template <typename Struct>
py::dict
fieldsOf(const Struct& fields);

/** \brief The same with all fields of the report, under the names that they have in
 * report.json. */
template <typename StageReport>
ReportObject
reportOf(const StageReport& report)
{
  return reportOf(fieldsOf(report), report);
}

/** \brief Converts the value of a field: a struct to an object with fields, numbers to
 * an array, a pose to a 4 x 4 array, what has no value to None. */
struct FieldValue {
  template <typename Value>
  py::object
  operator()(const Value& value) const
  {
    if constexpr (std::is_base_of_v<Report, Value>)
      return reportOf(value);
    else if constexpr (has_fields<Value>)
      return namespaceOf(fieldsOf(value));
    else
      return py::cast(value);
  }

  py::object
  operator()(const Eigen::Isometry3d& pose) const
  {
    return py::cast(pose.matrix());
  }

  py::object
  operator()(std::vector<double> values) const
  {
    return arrayOver(std::move(values));
  }

  template <typename Element>
  py::object
  operator()(const std::vector<Element>& values) const
  {
    py::list list;
    for (const Element& value : values)
      list.append((*this)(value));
    return py::object(std::move(list));
  }

  template <typename Value>
  py::object
  operator()(const std::optional<Value>& value) const
  {
    return value ? (*this)(*value) : py::none();
  }

  template <typename Value, std::size_t size>
  py::object
  operator()(const Named<Value, size>& named) const
  {
    if constexpr (std::is_enum_v<Value>)
      return py::str(nameIn(named.names, named.value));
    else {
      py::dict values;
      for (std::size_t i = 0; i < size; ++i)
        values[named.names[i]] = named.value[i];
      return py::object(std::move(values));
    }
  }
};

/** \brief The fields of a struct that names them. */
template <typename Struct>
py::dict
fieldsOf(const Struct& fields)
{
  py::dict all;
  visitFields(fields, [&all](const Field& field, const auto& value) {
    all[field.name] = FieldValue()(value);
  });
  return all;
}

} // namespace pcl::acmap::python
