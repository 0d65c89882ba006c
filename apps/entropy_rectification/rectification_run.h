#pragma once

#include "rectification_options.h"

#include <pcl/pipeline/observation_sequence.h>

#include <optional>

namespace pcl::acmap {

/** \brief Rectifies a map and writes it into a folder: all of what
 * pcl_entropy_rectification does.
 * \param[in] posed the observations; none: the scans of the options' log
 * \throws what its page tells as exit codes */
void
rectifyPoses(Tool& tool,
             const RectificationOptions& options,
             const std::optional<ObservationSequence>& posed);

} // namespace pcl::acmap
