#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <utility>
#include <vector>

namespace pcl::acmap::python {

namespace py = pybind11;

/** \brief A property that returns an array of numbers inside a Python object and keeps it
 * alive. */
template <typename Owner, typename Value>
py::cpp_function
memberArray(std::vector<py::ssize_t> shape, const Value* (*address)(const Owner&))
{
  return [shape = std::move(shape), address](const py::object& self) {
    return py::array(
        py::dtype::of<Value>(), shape, {}, address(self.cast<const Owner&>()), self);
  };
}

/** \brief A property that returns a list of the objects inside a Python object; each of
 * them keeps it alive. */
template <typename Owner, typename Value>
py::cpp_function
memberList(const std::vector<Value>& (*values)(const Owner&))
{
  return [values](const py::object& self) {
    py::list list;
    for (const Value& value : values(self.cast<const Owner&>()))
      list.append(py::cast(value, py::return_value_policy::reference_internal, self));
    return list;
  };
}

} // namespace pcl::acmap::python
