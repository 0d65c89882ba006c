#include "kernel_call.h"

namespace pcl::acmap::python {

bool
ProgressRelay::tell(double fraction, const std::string& step)
{
  const py::gil_scoped_acquire python;
  try {
    if (PyErr_CheckSignals() != 0)
      throw py::error_already_set();
    if (!listener_)
      return true;
    const py::object answer = (*listener_)(fraction, step);
    if (answer.is_none()) // the listener does not return anything
      return true;
    const int is_true = PyObject_IsTrue(answer.ptr());
    if (is_true < 0)
      throw py::error_already_set();
    return is_true == 1;
  }
  catch (const py::error_already_set&) {
    error_ = std::current_exception(); // kernels can only handle C++ exceptions;
                                       // rethrown by raise()
    return false;
  }
}

void
ProgressRelay::raise() const
{
  if (error_)
    std::rethrow_exception(error_);
}

} // namespace pcl::acmap::python
