#pragma once

#include <pcl/core/exceptions.h>

#include <functional>
#include <string>

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
class Progress {
public:
  explicit Progress(ProgressCallback callback = {})
  : callback_(std::move(callback))
  {}

  /** \throws CancelledException when the callback returned false */
  void
  tell(double fraction, const std::string& step) const
  {
    if (callback_ && !callback_(fraction, step))
      throw CancelledException("cancelled during " + step);
  }

private:
  ProgressCallback callback_;
};

} // namespace acmap
} // namespace pcl
