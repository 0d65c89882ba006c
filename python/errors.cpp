#include "bindings.h"

#include <pcl/core/exceptions.h>

namespace pcl::acmap::python {

namespace {

void
raise(PyObject* type, const PCLException& error)
{
  PyErr_SetString(type, messageOf(error).c_str());
}

void
translate(std::exception_ptr error)
{
  try {
    if (error)
      std::rethrow_exception(error);
  }
  catch (const BadArgumentException& e) {
    raise(PyExc_ValueError, e);
  }
  catch (const InitFailedException& e) {
    raise(PyExc_ValueError, e);
  }
  catch (const EmptyInputException& e) {
    raise(PyExc_ValueError, e);
  }
  catch (const MemoryLimitException& e) {
    raise(PyExc_MemoryError, e);
  }
  catch (const CancelledException& e) {
    raise(PyExc_KeyboardInterrupt, e);
  }
  catch (const IOException& e) {
    raise(PyExc_OSError, e);
  }
  catch (const PCLException& e) {
    raise(PyExc_RuntimeError, e);
  }
}

} // namespace

std::string
messageOf(const PCLException& error)
{
  const std::string text = error.what();
  const std::size_t colon = text.find(": ");
  return text.substr(colon == std::string::npos ? 0 : colon + 2);
}

void
bindErrors()
{
  pybind11::register_exception_translator(&translate);
}

} // namespace pcl::acmap::python
