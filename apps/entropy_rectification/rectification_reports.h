#pragma once

#include "map_observations.h"
#include "rectification_options.h"

namespace pcl::acmap {

/** \brief Reports the outcome as lines of the summary, in the JSON report and, if it is
 * Refused or Undetermined, as a warning. */
void
tellOutcome(Tool& tool,
            const RectificationOptions& options,
            const EntropyRectificationReport& report);

} // namespace pcl::acmap
