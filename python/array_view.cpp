#include "array_view.h"

#include <algorithm>
#include <limits>

namespace pcl::acmap::python {

namespace {

/** Values of an array that are separated by a constant number of bytes.
 * \throws py::value_error when the strides are not constant or are negative */
Column
stepThrough(const std::string& name, const py::array& array, int leading)
{
  Column column{array.data(), 0, 1};
  for (int axis = 0; axis < leading; ++axis)
    column.size *= static_cast<std::size_t>(array.shape(axis));
  requireCountable(name, column.size);
  if (column.size == 0)
    return {nullptr, 0, 0};
  const py::ssize_t stride = array.strides(leading - 1);
  const bool is_one_column = leading == 2 && array.shape(1) == 1;
  const bool is_even = leading == 1 || array.shape(0) == 1 || is_one_column ||
                       array.strides(0) == stride * array.shape(1);
  const py::ssize_t step = is_one_column ? array.strides(0) : stride;
  if (step < 0 || !is_even)
    throw py::value_error(
        name +
        (step < 0 ? ": runs backwards" : ": its rows do not follow each other evenly") +
        "; pass numpy.ascontiguousarray(" + name + "), which copies it");
  column.stride = static_cast<std::size_t>(step);
  return column;
}

/** The array as it is, or brought to the range of bytes: colours of 0 to 1, and those of 16
 * bits, would be black or torn after a mere conversion to them. */
std::string
scaled(const std::string& name, const py::array& array, const py::dtype& type)
{
  constexpr double brightest = 255;
  if (!type.equal(py::dtype::of<std::uint8_t>()) || array.size() == 0 ||
      std::string("fiub").find(array.dtype().kind()) == std::string::npos)
    return name;
  const auto largest =
      py::module_::import("numpy").attr("nanmax")(array).cast<double>();
  const char kind = array.dtype().kind();
  if (kind == 'b' || (kind == 'f' && largest <= 1))
    return "(" + name + " * 255)";
  return largest > brightest ? "(" + name + " * (255 / numpy.nanmax(" + name + ")))"
                             : name;
}

} // namespace

void
refuseShape(const std::string& name, const py::array& array, const std::string& shape)
{
  throw py::value_error(name + ": must have the shape " + shape + ", not " +
                        std::string(py::str(array.attr("shape"))));
}

void
requireCountable(const std::string& name, std::size_t points)
{
  constexpr std::size_t max_points = std::numeric_limits<std::int32_t>::max();
  if (points > max_points)
    throw py::value_error(name + ": " + std::to_string(points) +
                          " points are more than 2**31 - 1");
}

py::array
arrayOf(const std::string& name,
        const py::handle& argument,
        const py::dtype& type,
        const std::vector<py::ssize_t>& ranks,
        const std::string& shape)
{
  const std::string wanted = "numpy." + std::string(py::str(type.attr("name")));
  if (!py::isinstance<py::array>(argument))
    throw py::type_error(name + ": must be a numpy array of " + wanted + ", not " +
                         std::string(py::str(py::type::of(argument).attr("__name__"))));
  auto array = py::reinterpret_borrow<py::array>(argument);
  if (!array.dtype().equal(type))
    throw py::type_error(name + ": " + std::string(py::str(array.dtype())) +
                         " is refused, nothing is converted unasked: pass " +
                         scaled(name, array, type) + ".astype(" + wanted + ")");
  if (std::find(ranks.begin(), ranks.end(), array.ndim()) == ranks.end())
    refuseShape(name, array, shape);
  return array;
}

PointRows
pointRowsOf(const std::string& name, const py::handle& argument)
{
  const std::string shape = "(n, 3) or (h, w, 3)";
  const py::array array =
      arrayOf(name, argument, py::dtype::of<float>(), {2, 3}, shape);
  const int axis = static_cast<int>(array.ndim()) - 1;
  if (array.shape(axis) != 3)
    refuseShape(name, array, shape);
  const Column column = stepThrough(name, array, axis);
  if (column.size > 0 && array.strides(axis) != sizeof(float))
    throw py::value_error(name +
                          ": the coordinates of a point do not stand together; pass "
                          "numpy.ascontiguousarray(" +
                          name + "), which copies it");
  return {{column.first, column.stride, column.size},
          axis == 2 ? static_cast<std::size_t>(array.shape(1)) : 0};
}

void
requireAsMany(const std::string& name, std::size_t number, std::size_t points)
{
  if (number != points)
    throw py::value_error(name + ": there are " + std::to_string(number) + " for " +
                          std::to_string(points) + " points");
}

Column
columnOf(const std::string& name,
         const py::handle& argument,
         const py::dtype& type,
         std::size_t points)
{
  const py::array array = arrayOf(name, argument, type, {1, 2}, "(n,) or (h, w)");
  const Column column = stepThrough(name, array, static_cast<int>(array.ndim()));
  requireAsMany(name, column.size, points);
  return column;
}

} // namespace pcl::acmap::python
