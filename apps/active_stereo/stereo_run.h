#pragma once

#include "stereo_options.h"

namespace pcl::acmap {

/** \brief Makes the observations of a session, or the one of image lists, as files of a
 * folder: all of what pcl_active_stereo does.
 * \throws what its page tells as exit codes; InterruptedPartway when observations were
 * finished before an interruption, which are kept */
void
makeObservations(Tool& tool, const StereoOptions& options);

} // namespace pcl::acmap
