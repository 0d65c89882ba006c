#pragma once

#include "shown.h"

#include <pcl/core/impl/point_view.h>
#include <pcl/core/triangle_mesh.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap::python {

struct ShownPoints {
  static constexpr auto name = py::detail::const_name("numpy.ndarray[float32[n, 3]]");
};
struct ShownIndices {
  static constexpr auto name = py::detail::const_name("numpy.ndarray[int32[n]]");
};
struct ShownWeights {
  static constexpr auto name = py::detail::const_name("numpy.ndarray[float32[n]]");
};
struct ShownPose {
  static constexpr auto name = py::detail::const_name("numpy.ndarray[float64[4, 4]]");
};
struct ShownPoses {
  static constexpr auto name =
      py::detail::const_name("numpy.ndarray[float64[k, 4, 4]]");
};

using PointArgument = ShownAs<ShownPoints>;
using IndexArgument = ShownAs<ShownIndices>;
using WeightArgument = ShownAs<ShownWeights>;
using SinglePoseArgument = ShownAs<ShownPose>;
using PoseArgument = ShownAs<ShownPoses>;

/** \brief Points of an array; the array must outlive the view. */
struct PointRows {
  PointView view;
  std::size_t width = 0; ///< points per row; 0 unless the array is (h, w, 3)
};

/** \brief View of an array of (n, 3) or (h, w, 3) float32, without a copy.
 * \param[in] name of the argument, for messages
 * \throws py::type_error when it is not an array of float32
 * \throws py::value_error when its shape or strides are not supported */
PointRows
pointRowsOf(const std::string& name, const py::handle& argument);

/** \brief A column of an array with one value per point. */
struct Column {
  const void* first = nullptr;
  std::size_t stride = 0; ///< bytes
  std::size_t size = 0;
};

/** \brief View of an array of (n,), or (h, w), values of a type, without a copy.
 * \throws as \ref pointRowsOf, also unless there is one value per point */
Column
columnOf(const std::string& name,
         const py::handle& argument,
         const py::dtype& type,
         std::size_t points);

/** \brief Checks the type and rank of an array, and returns it without a copy.
 * \throws as \ref pointRowsOf */
py::array
arrayOf(const std::string& name,
        const py::handle& argument,
        const py::dtype& type,
        const std::vector<py::ssize_t>& ranks,
        const std::string& shape);

/** \brief Refuses the shape of an array. \throws py::value_error always */
[[noreturn]] void
refuseShape(const std::string& name, const py::array& array, const std::string& shape);

/** \brief Requires that int32 indices can count the points. \throws py::value_error */
void
requireCountable(const std::string& name, std::size_t points);

/** \brief Requires one entry per point. \throws py::value_error */
void
requireAsMany(const std::string& name, std::size_t number, std::size_t points);

/** \brief Moves a value into a Python capsule, which can be the owner of arrays. */
template <typename Value>
std::pair<Value&, py::capsule>
owned(Value value)
{
  auto* const moved = new Value(std::move(value));
  return {*moved, py::capsule(moved, [](void* pointer) {
            delete static_cast<Value*>(pointer);
          })};
}

/** \brief An array that refers to one field of each record of a vector, without a copy.
 * \param[in] address function that returns the address of the field's first value
 * \param[in] columns number of values per record; 0: one value, and a 1-D array
 * \param[in] owner of the vector; the array keeps a reference to it */
template <typename Value, typename Record, typename Allocator, typename Address>
py::array_t<Value>
fieldOf(const std::vector<Record, Allocator>& records,
        py::ssize_t columns,
        const py::handle& owner,
        const Address& address)
{
  const Value* const first = records.empty() ? nullptr : address(records.front());
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(records.size())};
  std::vector<py::ssize_t> strides = {sizeof(Record)};
  if (columns > 0) {
    shape.push_back(columns);
    strides.push_back(sizeof(Value));
  }
  return py::array_t<Value>(shape, strides, first, owner);
}

/** \brief Moves a vector of numbers into an array. */
template <typename Value, typename Allocator>
py::array_t<Value>
arrayOver(std::vector<Value, Allocator>&& values)
{
  const auto [kept, owner] = owned(std::move(values));
  return fieldOf<Value>(kept, 0, owner, [](const Value& value) { return &value; });
}

} // namespace pcl::acmap::python
