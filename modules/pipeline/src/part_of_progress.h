#pragma once

#include <pcl/core/progress.h>

namespace pcl::acmap {

/** \brief Callback of a step that is a part of a run, from one share of it to another. */
inline ProgressCallback
partOf(const ProgressCallback& callback, double from, double to)
{
  if (!callback)
    return {};
  return [callback, from, to](double fraction, const std::string& step) {
    return callback(from + (to - from) * fraction, step);
  };
}

} // namespace pcl::acmap
