#pragma once

#include "map_observations.h"
#include "rectification_options.h"

namespace pcl::acmap {

/** \brief The outcome as lines of the summary, as parts of the JSON report and, where
 * it is Refused or Undetermined, as a warning. */
void
tellOutcome(Tool& tool,
            const RectificationOptions& options,
            const EntropyRectificationReport& report);

} // namespace pcl::acmap
