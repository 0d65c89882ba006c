#pragma once

#include <pcl/core/exceptions.h>

#include <functional>
#include <string>

namespace pcl {

/** \brief Called now and then by a running verb, from the thread that called the verb.
 *
 * \param[in] fraction how much of the work is done, in [0, 1], never falling
 * \param[in] step what is being done, in a word or two
 * \return false to stop: the verb throws \ref CancelledException. \ingroup core
 */
using ProgressCallback = std::function<bool(double fraction, const std::string& step)>;

namespace acmap {

/** \brief Tells a callback, if there is one, and turns its refusal into an exception. */
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
