#pragma once

#include "rectification_options.h"

#include <pcl/pipeline/laser_observations.h>

namespace pcl::acmap {

/** \brief Reads every n-th scan of a CARMEN log or of a bag, as a step of the tool.
 * \throws InputFileException as loadCarmenLog and loadBagScans */
LaserObservations
readScans(const RectificationOptions& options, StageLog& log);

} // namespace pcl::acmap
