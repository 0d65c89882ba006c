#include "bindings.h"

#include <pcl/core/exceptions.h>

namespace pcl::acmap::python {

namespace {

/** Removes the source location that PCL prepends to its messages. */
void
raise(PyObject* type, const PCLException& error)
{
  const std::string text = error.what();
  const std::size_t colon = text.find(": ");
  PyErr_SetString(type,
                  text.substr(colon == std::string::npos ? 0 : colon + 2).c_str());
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

void
bindErrors()
{
  pybind11::register_exception_translator(&translate);
}

} // namespace pcl::acmap::python
