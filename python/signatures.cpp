#include "bindings.h"

#include <cstdlib>
#include <cstring>
#include <string>

namespace pcl::acmap::python {

namespace py = pybind11;

namespace {

/** The parameters of `name(one: int, *, other: float = 1) -> str` without their types. */
std::string
parametersOf(const std::string& signature)
{
  std::string parameters;
  int depth = 0;
  bool is_type = false;
  for (const char c : signature.substr(signature.find('('))) {
    depth += c == '(' || c == '[' ? 1 : 0;
    if (depth == 1 && (c == ':' || c == '=' || c == ','))
      is_type = c == ':';
    depth -= c == ')' || c == ']' ? 1 : 0;
    if (depth == 0)
      return parameters + ')';
    if (!is_type)
      parameters += c;
  }
  return parameters;
}

/** Python reads the parameters of a function of C from its text, before a line "--", and
 * leaves them out in __doc__. The text begins with the line that pybind11 writes for it.
 * \param[in] owner type of the parameter that has no name, that of a property */
void
giveSignature(py::handle function, const std::string& owner)
{
  if (PyInstanceMethod_Check(function.ptr()))
    function = PyInstanceMethod_GET_FUNCTION(function.ptr());
  if (!PyCFunction_Check(function.ptr()))
    return;
  PyMethodDef& method = *reinterpret_cast<PyCFunctionObject*>(function.ptr())->m_ml;
  std::string text = method.ml_doc ? method.ml_doc : "";
  if (text.find(" -> ") == std::string::npos) // it is not one of pybind11
    return;
  const std::string unnamed = "(arg0: ";
  const std::size_t place = text.find(unnamed);
  if (place != std::string::npos)
    text.replace(place, text.find(')') - place, "(self: " + owner);
  text = method.ml_name + parametersOf(text) + "\n--\n\n" + text;
  std::free(const_cast<char*>(method.ml_doc)); // as pybind11 does
  method.ml_doc = strdup(text.c_str());
}

} // namespace

void
bindSignatures(const py::module_& module)
{
  for (const auto [name, member] : module.attr("__dict__").cast<py::dict>()) {
    giveSignature(member, "");
    if (!PyType_Check(member.ptr()))
      continue;
    const std::string owner = "acmap." + name.cast<std::string>();
    for (const py::handle inside : member.attr("__dict__").attr("values")())
      giveSignature(py::getattr(inside, "fget", inside), owner);
  }
}

} // namespace pcl::acmap::python
