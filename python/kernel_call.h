#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/progress.h>

#include <pybind11/pybind11.h>

#include <exception>
#include <optional>
#include <string>
#include <utility>

namespace pcl::acmap::python {

namespace py = pybind11;

/** \brief A function that is called with (fraction, step). */
class ProgressFunction : public py::function {
  PYBIND11_OBJECT_DEFAULT(ProgressFunction, function, PyCallable_Check)
};

/** \brief The `progress` argument of Python functions. */
using Listener = std::optional<ProgressFunction>;

/** \brief Reports the progress of what runs without the GIL to Python, and checks for
 * signals such as Ctrl-C. */
class ProgressRelay {
public:
  explicit ProgressRelay(const Listener& listener)
  : listener_(listener)
  {}

  /** \return false when it shall stop */
  bool
  tell(double fraction, const std::string& step);

  /** \brief Rethrows the Python exception, if there is one. */
  void
  raise() const;

private:
  const Listener& listener_;
  std::exception_ptr error_;
};

/** \brief Calls stage (callback) without the GIL; the callback is for the
 * setProgressCallback of a class.
 * \throws py::error_already_set raised by the listener or a signal handler */
template <typename Stage>
auto
callStage(const Listener& listener, const Stage& stage)
{
  ProgressRelay relay(listener);
  try {
    const py::gil_scoped_release others_may_run;
    return stage(ProgressCallback([&relay](double fraction, const std::string& step) {
      return relay.tell(fraction, step);
    }));
  }
  catch (const CancelledException&) {
    relay.raise();
    throw;
  }
}

/** \brief Calls kernel (progress) as \ref callStage does. */
template <typename Kernel>
auto
callKernel(const Listener& listener, const Kernel& kernel)
{
  return callStage(listener, [&](ProgressCallback callback) {
    return kernel(Progress(std::move(callback)));
  });
}

} // namespace pcl::acmap::python

namespace pybind11::detail {

template <>
struct handle_type_name<pcl::acmap::python::ProgressFunction> {
  static constexpr auto name = const_name("Callable[[float, str], object]");
};

} // namespace pybind11::detail
