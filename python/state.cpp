#include "bindings.h"
#include "struct_members.h"
#include "told.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl::acmap::python {

namespace {

/** What a value without pointers consists of: numbers of a type, so many. */
template <typename Value, typename = void>
struct Flat {
  static constexpr std::size_t size = 0; ///< it has pointers
};

template <typename Value>
struct Flat<Value, std::enable_if_t<std::is_arithmetic_v<Value>>> {
  using Number = Value;
  static constexpr std::size_t size = 1;
};

template <typename Value>
struct Flat<Value, std::enable_if_t<std::is_enum_v<Value>>> {
  using Number = std::underlying_type_t<Value>;
  static constexpr std::size_t size = 1;
};

template <typename Value, int rows, int columns>
struct Flat<Eigen::Matrix<Value, rows, columns>> {
  using Number = Value;
  static constexpr std::size_t size = static_cast<std::size_t>(rows) * columns;
};

template <>
struct Flat<Eigen::Isometry3d> : Flat<Eigen::Matrix4d> {};

inline void
requireState(bool fits)
{
  if (!fits)
    throw py::value_error("the pickle does not fit: another version of acmap wrote it");
}

template <typename Value>
using NumberArray = py::array_t<typename Flat<Value>::Number, py::array::c_style>;

/** A row of numbers for each value, copied. */
template <typename Value>
NumberArray<Value>
rowsOf(const Value* values, std::size_t size)
{
  static_assert(sizeof(Value) ==
                Flat<Value>::size * sizeof(typename Flat<Value>::Number));
  return NumberArray<Value>(
      {static_cast<py::ssize_t>(size), static_cast<py::ssize_t>(Flat<Value>::size)},
      reinterpret_cast<const typename Flat<Value>::Number*>(values));
}

/** The values of these rows. \throws py::value_error if there are other ones */
template <typename Value>
std::vector<Value>
valuesOf(const py::handle& state)
{
  const auto rows = state.cast<NumberArray<Value>>();
  requireState(rows.ndim() == 2 && rows.shape(1) == Flat<Value>::size);
  std::vector<Value> values(static_cast<std::size_t>(rows.shape(0)));
  if (!values.empty())
    std::memcpy(
        static_cast<void*>(values.data()), rows.data(), values.size() * sizeof(Value));
  return values;
}

/** Converts a value to what pickle can handle, and back: a struct to the tuple of
 * its members, numbers to an array.
 * \throws py::value_error, py::cast_error by set, for anything else */
template <typename Value>
struct State {
  static py::object
  get(Value& value)
  {
    if constexpr (std::is_base_of_v<py::object, Value>)
      return value;
    else if constexpr (std::is_arithmetic_v<Value> ||
                       std::is_same_v<Value, std::string>)
      return py::cast(value);
    else if constexpr (Flat<Value>::size > 0)
      return rowsOf(&value, 1);
    else
      return std::apply(
          [](auto&... member) -> py::object {
            return py::make_tuple(
                State<std::remove_reference_t<decltype(member)>>::get(member)...);
          },
          membersOf(value));
  }

  static void
  set(Value& value, const py::handle& state)
  {
    if constexpr (std::is_arithmetic_v<Value> || std::is_same_v<Value, std::string> ||
                  std::is_base_of_v<py::object, Value>)
      value = state.cast<Value>();
    else if constexpr (Flat<Value>::size > 0) {
      const std::vector<Value> values = valuesOf<Value>(state);
      requireState(values.size() == 1);
      value = values.front();
    }
    else
      std::apply(
          [&state](auto&... member) {
            const auto states = state.cast<py::tuple>();
            requireState(states.size() == sizeof...(member));
            std::size_t i = 0;
            (State<std::remove_reference_t<decltype(member)>>::set(member, states[i++]),
             ...);
          },
          membersOf(value));
  }
};

/** The same for many values: flat ones to an array, others to a list. */
template <typename Element>
struct State<std::vector<Element>> {
  static py::object
  get(std::vector<Element>& values)
  {
    if constexpr (Flat<Element>::size > 0)
      return rowsOf(values.data(), values.size());
    else {
      py::list states;
      for (Element& value : values)
        states.append(State<Element>::get(value));
      return py::object(std::move(states));
    }
  }

  static void
  set(std::vector<Element>& values, const py::handle& state)
  {
    if constexpr (Flat<Element>::size > 0)
      values = valuesOf<Element>(state);
    else
      for (const py::handle one : state.cast<py::list>())
        State<Element>::set(values.emplace_back(), one);
  }
};

template <typename Element, std::size_t size>
struct State<std::array<Element, size>> {
  static py::object
  get(std::array<Element, size>& values)
  {
    std::vector<Element> copy(values.begin(), values.end());
    return State<std::vector<Element>>::get(copy);
  }

  static void
  set(std::array<Element, size>& values, const py::handle& state)
  {
    std::vector<Element> copy;
    State<std::vector<Element>>::set(copy, state);
    requireState(copy.size() == size);
    std::copy(copy.begin(), copy.end(), values.begin());
  }
};

/** Pickles a class, and tells some of its properties in its repr.
 * \param[in] told their names, after spaces */
template <typename Struct>
void
bindState(const char* told)
{
  auto bound = py::reinterpret_borrow<py::class_<Struct>>(py::type::of<Struct>());
  bound.def("__repr__", toldBy(told));
  bound.def(
      py::pickle([](Struct& value) { return py::tuple(State<Struct>::get(value)); },
                 [](const py::tuple& state) {
                   Struct value;
                   State<Struct>::set(value, state);
                   return value;
                 }),
      py::arg("state"));
}

} // namespace

void
bindStates()
{
  bindState<PlanePolygon>("outer holes");
  bindState<PlanePatch>("coefficients support rmse area polygons");
  bindState<CylinderPatch>("axis_point axis_direction radius is_hollow area");
  bindState<BoxPatch>("center size");
  bindState<RecessPatch>("center size wall leaf");
  bindState<TexturePicture>("colors");
  bindState<TextureChart>("plane polygon colors");
  bindState<MapEdge>("kind vertices planes");
  bindState<MapFace>("plane polygon outer holes");
  bindState<MapTopology>("vertices edges faces");
  bindState<MapRoom>("center area planes openings");
  bindState<MapOpening>("kind start end bottom top rooms");
  bindState<ReportedMap>(
      "planes area cylinders boxes recesses charts rooms openings poses up report");
}

} // namespace pcl::acmap::python
