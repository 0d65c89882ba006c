#include "told.h"

#include <pybind11/numpy.h>

#include <sstream>

namespace pcl::acmap::python {

namespace {

constexpr py::ssize_t few = 4; ///< values that are told one by one

std::string
formatted(const py::handle& number)
{
  return py::str(py::str("{:.4g}").attr("format")(number));
}

std::string
toldArray(const py::array& array)
{
  if (array.ndim() != 1 || array.size() > few)
    return py::str(py::str("{} {}").attr("format")(array.attr("shape"), array.dtype()));
  std::string values;
  for (const py::handle value : array)
    values += (values.empty() ? "" : ", ") + formatted(value);
  return "[" + values + "]";
}

} // namespace

std::string
told(const py::handle& value)
{
  if (value.is_none())
    return {};
  if (py::isinstance<py::float_>(value))
    return formatted(value);
  if (py::isinstance<py::int_>(value))
    return py::repr(value);
  if (py::isinstance<py::array>(value))
    return toldArray(py::reinterpret_borrow<py::array>(value));
  if (py::hasattr(value, "outcome") && !value.attr("outcome").is_none())
    return py::repr(value.attr("outcome"));
  if (!py::hasattr(value, "__len__"))
    return {};
  const std::size_t size = py::len(value);
  if (size == 0)
    return {};
  return py::isinstance<py::str>(value) ? std::string(py::repr(value))
                                        : std::to_string(size);
}

std::string
toldFields(const py::handle& object, const std::string& names)
{
  std::istringstream words(names);
  std::string fields;
  for (std::string name; words >> name;) {
    const std::string value = told(object.attr(name.c_str()));
    if (!value.empty())
      fields += (fields.empty() ? "" : ", ") + name + "=" + value;
  }
  const py::handle type = py::type::handle_of(object);
  return py::str(py::str("acmap.{}({})").attr("format")(type.attr("__name__"), fields));
}

} // namespace pcl::acmap::python
