#pragma once

#include <pcl/core/time_left.h>

#include <string>

namespace pcl::acmap {

/** \brief The times of the last run of a kind on this machine, from the user's folder for
 * caches: `$XDG_CACHE_HOME/acmap` or `$HOME/.cache/acmap`. Empty if there are none, or they
 * cannot be read. */
RunTimes
recallRun(const std::string& kind);

/** \brief Keeps the times of a run there, silently not if that is not possible. */
void
rememberRun(const std::string& kind, const RunTimes& times);

} // namespace pcl::acmap
