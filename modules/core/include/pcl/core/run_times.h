#pragma once

#include <pcl/core/export.h>
#include <pcl/core/time_left.h>

#include <string>

namespace pcl {

/** \brief The times of the last run of a kind on this machine, for a \ref ProgressBar, from
 * the user's folder for caches, `$XDG_CACHE_HOME/acmap` or `$HOME/.cache/acmap`. Empty if there
 * are none, or they cannot be read. \ingroup core */
ACMAP_EXPORT RunTimes
recallRunTimes(const std::string& kind);

/** \brief Keeps the times of a run there, silently not if that is not possible.
 * \param[in] times such as \ref ProgressBar::times, of a run that was finished \ingroup core */
ACMAP_EXPORT void
rememberRunTimes(const std::string& kind, const RunTimes& times);

} // namespace pcl
