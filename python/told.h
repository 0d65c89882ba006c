#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace pcl::acmap::python {

namespace py = pybind11;

/** \brief What stands for an object in the one line of the repr of another: a number, a
 * text or a few numbers as they are, an array by its shape and type, a list by its size, a
 * report by its outcome; nothing if that tells nothing. */
std::string
told(const py::handle& value);

/** \brief `acmap.Name(one=…, other=…)` \param[in] names of attributes, after spaces; those
 * that tell nothing are left out */
std::string
toldFields(const py::handle& object, const std::string& names);

/** \brief A `__repr__` that calls \ref toldFields. */
inline auto
toldBy(std::string names)
{
  return [names = std::move(names)](const py::object& self) {
    return toldFields(self, names);
  };
}

} // namespace pcl::acmap::python
