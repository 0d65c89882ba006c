#pragma once

#include "egomotion_options.h"
#include "tool.h"

#include <pcl/pipeline/observation_sequence.h>

#include <optional>

namespace pcl::acmap {

/** \brief Estimates the poses of a sequence and writes them into a folder: all of what
 * pcl_visual_egomotion does.
 * \param[in] opened files of the inputs, if somebody has opened them before
 * \throws what its page names as exit codes */
void
estimatePoses(Tool& tool,
              const EgomotionOptions& options,
              const std::optional<ObservationSequence>& opened = {});

} // namespace pcl::acmap
