#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/progress.h>

#include <pybind11/pybind11.h>

#include <exception>
#include <optional>
#include <string>

namespace pcl::acmap::python {

namespace py = pybind11;

/** \brief The `progress` argument of Python functions: called with (fraction, step). */
using Listener = std::optional<py::function>;

/** \brief Reports the progress of a kernel that runs without the GIL to Python, and
 * checks for signals such as Ctrl-C. */
class ProgressRelay {
public:
  explicit ProgressRelay(const Listener& listener)
  : listener_(listener)
  {}

  /** \return false when the kernel shall stop */
  bool
  tell(double fraction, const std::string& step);

  /** \brief Rethrows the Python exception, if there is one. */
  void
  raise() const;

private:
  const Listener& listener_;
  std::exception_ptr error_;
};

/** \brief Calls kernel (progress) without the GIL.
 * \throws py::error_already_set raised by the listener or a signal handler */
template <typename Kernel>
auto
callKernel(const Listener& listener, const Kernel& kernel)
{
  ProgressRelay relay(listener);
  try {
    const py::gil_scoped_release others_may_run;
    return kernel(Progress([&relay](double fraction, const std::string& step) {
      return relay.tell(fraction, step);
    }));
  }
  catch (const CancelledException&) {
    relay.raise();
    throw;
  }
}

} // namespace pcl::acmap::python
