#pragma once

#include "rectification_options.h"

#include <pcl/pipeline/observation_sequence.h>

#include <optional>

namespace pcl::acmap {

/** \brief Rectifies a map and writes it into a folder: the complete work of
 * pcl_entropy_rectification.
 * \param[in] posed the observations; none: the scans of the options' log
 * \throws according to the exit codes of its documentation page */
void
rectifyPoses(Tool& tool,
             const RectificationOptions& options,
             const std::optional<ObservationSequence>& posed);

} // namespace pcl::acmap
