#pragma once

#include "egomotion_options.h"
#include "tool.h"

#include <pcl/pipeline/observation_sequence.h>

#include <optional>

namespace pcl::acmap {

/** \brief Estimates the poses of a sequence and writes them into a folder: the complete
 * work of pcl_visual_egomotion.
 * \param[in] opened files of the inputs, if they are already open
 * \throws according to the exit codes of its documentation page */
void
estimatePoses(Tool& tool,
              const EgomotionOptions& options,
              const std::optional<ObservationSequence>& opened = {});

} // namespace pcl::acmap
