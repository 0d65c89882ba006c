#pragma once

#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>

namespace pcl::acmap::python {

/** \brief The values of an enumeration and their names in Python. */
template <typename Value, std::size_t size>
using NamedChoices = std::array<std::pair<const char*, Value>, size>;

/** \throws pybind11::value_error that lists the valid names */
template <typename Value, std::size_t size>
Value
chosen(const std::string& argument,
       const std::string& name,
       const NamedChoices<Value, size>& choices)
{
  std::string names;
  for (const auto& [known, value] : choices) {
    if (name == known)
      return value;
    names += std::string(names.empty() ? "'" : ", '") + known + "'";
  }
  throw pybind11::value_error(argument + " = '" + name +
                              "' is refused: it must be one of " + names);
}

template <typename Value, std::size_t size>
std::string
nameOf(Value value, const NamedChoices<Value, size>& choices)
{
  for (const auto& [name, known] : choices)
    if (known == value)
      return name;
  return {};
}

} // namespace pcl::acmap::python
