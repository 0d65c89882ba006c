#include "bindings.h"

#include <pcl/core/exceptions.h>

namespace pcl::acmap::python {

namespace {

PyObject* cancelled = nullptr; ///< acmap.Cancelled, lives as long as the interpreter

void
raise(PyObject* type, const PCLException& error)
{
  PyErr_SetString(type, error.what());
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
    raise(cancelled, e);
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
bindErrors(pybind11::module_& module)
{
  cancelled = PyErr_NewExceptionWithDoc("acmap.Cancelled",
                                        "A progress function returned False.",
                                        PyExc_Exception,
                                        nullptr);
  if (cancelled == nullptr)
    throw pybind11::error_already_set();
  module.attr("Cancelled") = pybind11::handle(cancelled);
  pybind11::register_exception_translator(&translate);
}

} // namespace pcl::acmap::python
