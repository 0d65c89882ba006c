#pragma once

#include "shown.h"

#include <string>

namespace pcl::acmap::python {

struct ShownPath {
  static constexpr auto name = py::detail::const_name("Union[str, os.PathLike]");
};

/** \brief A str, or what has a path, such as a pathlib.Path. */
using PathArgument = ShownAs<ShownPath>;

/** \throws py::type_error that names the argument when it is none of them */
inline std::string
pathOf(const std::string& name, const PathArgument& argument)
{
  PyObject* const path = PyOS_FSPath(argument.ptr());
  if (path == nullptr) {
    PyErr_Clear();
    throw py::type_error(name + ": must be a str or a path, not " +
                         std::string(py::str(py::type::of(argument).attr("__name__"))));
  }
  const auto os = py::module_::import("os");
  return os.attr("fsencode")(py::reinterpret_steal<py::object>(path))
      .cast<std::string>();
}

} // namespace pcl::acmap::python
