#pragma once

#include <pybind11/pybind11.h>

namespace pcl::acmap::python {

namespace py = pybind11;

/** \brief An object that pybind11 neither checks nor converts. An argument is checked by
 * the functions below, whose messages contain its name.
 * \tparam Shown its `name` is the type that signatures show */
template <typename Shown>
class ShownAs : public py::object {
  PYBIND11_OBJECT_DEFAULT(ShownAs, object, anything)
  static bool
  anything(PyObject*)
  {
    return true;
  }
};

/** \brief A list; signatures show the type of its elements. */
template <typename Value>
class ListOf : public py::list {
  PYBIND11_OBJECT_DEFAULT(ListOf, list, PyList_Check)
};

struct ShownReport {
  static constexpr auto name = py::detail::const_name("acmap.Report");
};

struct ShownReportOrNone {
  static constexpr auto name = py::detail::const_name("Optional[acmap.Report]");
};

using ReportObject = ShownAs<ShownReport>;
using ReportOrNone = ShownAs<ShownReportOrNone>;

} // namespace pcl::acmap::python

namespace pybind11::detail {

template <typename Shown>
struct handle_type_name<pcl::acmap::python::ShownAs<Shown>> {
  static constexpr auto name = Shown::name;
};

template <typename Value>
struct handle_type_name<pcl::acmap::python::ListOf<Value>> {
  static constexpr auto name =
      const_name("List[") + make_caster<Value>::name + const_name("]");
};

} // namespace pybind11::detail
