#pragma once

#include "told.h"

#include <pybind11/stl.h>

#include <utility>

namespace pcl::acmap::python {

/** \brief What the result of a stage consists of: a Python object with a name. */
template <typename Result, typename Value>
struct ResultField {
  const char* name;
  Value Result::*member;
  const char* help;
};

template <typename Result, typename Value>
ResultField<Result, Value>
field(const char* name, Value Result::*member, const char* help)
{
  return {name, member, help};
}

/** \brief Completes a result whose fields were unpickled. A result with more than its
 * fields has its own overload, which throws py::value_error if they do not fit. */
template <typename Result>
Result
restored(Result result)
{
  return result;
}

/** \brief Binds the result of a stage: properties, pickling as a dict of them, repr.
 * \param[in] told names of the properties that its repr tells */
template <typename Result, typename... Value>
void
bindResult(py::module_& module,
           const char* name,
           const char* help,
           const char* told,
           const ResultField<Result, Value>&... fields)
{
  py::class_<Result> bound(module, name, help);
  (bound.def_readonly(fields.name, fields.member, fields.help), ...);
  bound.def("__repr__", toldBy(told));
  bound.def(py::pickle(
                [fields...](const Result& result) {
                  py::dict state;
                  ((state[fields.name] = result.*fields.member), ...);
                  return state;
                },
                [fields...](const py::dict& state) {
                  Result result;
                  ((result.*fields.member = state[fields.name].template cast<Value>()),
                   ...);
                  return restored(std::move(result));
                }),
            py::arg("state"));
}

} // namespace pcl::acmap::python
