#pragma once

#include "array_view.h"

#include <utility>
#include <vector>

namespace pcl::acmap::python {

/** \brief A property that returns an array of numbers inside a Python object and keeps it
 * alive. */
template <typename Owner, typename Value>
py::cpp_function
memberArray(std::vector<py::ssize_t> shape, const Value* (*address)(const Owner&))
{
  return [shape = std::move(shape), address](const py::object& self) {
    return py::array_t<Value>(shape, address(self.cast<const Owner&>()), self);
  };
}

/** \brief A property that returns a list of the objects inside a Python object; each of
 * them keeps it alive. */
template <typename Owner, typename Value>
py::cpp_function
memberList(const std::vector<Value>& (*values)(const Owner&))
{
  return [values](const py::object& self) {
    ListOf<Value> list;
    for (const Value& value : values(self.cast<const Owner&>()))
      list.append(py::cast(value, py::return_value_policy::reference_internal, self));
    return list;
  };
}

} // namespace pcl::acmap::python
