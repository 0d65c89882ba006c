#pragma once

#include "egomotion_run.h"

namespace pcl::acmap {

/** \brief What was asked for, and what came of it. */
struct EgomotionResult {
  ObservationList list;
  EgomotionRun run;
};

/** \brief Estimates the poses of a sequence and writes them into a folder: all of what
 * pcl_visual_egomotion does.
 * \throws what its page tells as exit codes */
EgomotionResult
estimatePoses(Tool& tool, const EgomotionOptions& options);

} // namespace pcl::acmap
