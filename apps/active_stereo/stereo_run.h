#pragma once

#include "stereo_options.h"

namespace pcl::acmap {

/** \brief Computes the observations of a session, or the one of image lists, and writes
 * them into a folder: the complete work of pcl_active_stereo.
 * \throws according to the exit codes of its documentation page; InterruptedPartway
 * when observations were finished before an interruption, which are kept */
void
makeObservations(Tool& tool, const StereoOptions& options);

} // namespace pcl::acmap
