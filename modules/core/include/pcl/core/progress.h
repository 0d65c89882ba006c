#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>

#include <functional>
#include <string>
#include <utility>

namespace pcl {

/** \brief Called repeatedly during a run, from the thread that started it.
 *
 * \param[in] fraction completed part of the work, in [0, 1], never decreasing
 * \param[in] step name of the current step, one or two words
 * \return false to stop: the run throws \ref CancelledException. \ingroup core */
using ProgressCallback = std::function<bool(double fraction, const std::string& step)>;

namespace acmap {

/** \brief Calls a callback, if there is one, and throws an exception if it returns
 * false. */
class ACMAP_EXPORT Progress {
public:
  explicit Progress(ProgressCallback callback = {})
  : callback_(std::move(callback))
  {}

  ~Progress();

  Progress(const Progress&) = delete;

  Progress&
  operator=(const Progress&) = delete;

  /** \throws CancelledException when the callback returned false */
  void
  tell(double fraction, const std::string& step) const;

private:
  ProgressCallback callback_;
};

/** \brief To be called now and then in long loops: keeps arrays in files within their
 * ScratchMemory, and ten times a second tells the callback of the Progress that this thread
 * told last the same again, so that it can stop the run.
 * \throws CancelledException when the callback returned false */
ACMAP_EXPORT void
pollRun();

} // namespace acmap
} // namespace pcl
