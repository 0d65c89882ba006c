#pragma once

#include <pcl/core/progress.h>

namespace pcl::acmap {

/** \brief Progress callback of a step that covers a part of the whole progress, between
 * two fractions. */
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
