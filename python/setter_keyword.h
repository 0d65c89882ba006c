#pragma once

#include "bindings.h"

#include <pcl/exceptions.h>

#include <optional>
#include <string>
#include <type_traits>

namespace pcl::acmap::python {

/** \brief Gives the value of a keyword to a setter of the object that has the settings.
 * \throws py::value_error that names the keyword, with the setter's own message, if it
 * refuses the value */
template <typename Stage, typename Base, typename Value>
void
setKeyword(const char* keyword,
           Stage& stage,
           void (Base::*set)(Value),
           const std::decay_t<Value>& value)
{
  try {
    (stage.*set)(value);
  }
  catch (const BadArgumentException& refused) {
    throw pybind11::value_error(std::string(keyword) + ": " + refused.what());
  }
}

/** \brief The same for a keyword that may be None, which leaves the default. */
template <typename Stage, typename Base, typename Value>
void
setKeyword(const char* keyword,
           Stage& stage,
           void (Base::*set)(Value),
           const std::optional<std::decay_t<Value>>& value)
{
  if (value)
    setKeyword(keyword, stage, set, *value);
}

} // namespace pcl::acmap::python
