#pragma once

#include "rectification_options.h"

#include <pcl/core/planar_scan.h>
#include <pcl/pipeline/sequence_consolidation.h>

#include <vector>

namespace pcl::acmap {

/** \brief The scans of a log, to be rectified. */
struct LogObservations : ConsolidatedObservations {
  std::vector<PlanarScan> scans;
  std::size_t points = 0; ///< echoes
};

/** \brief Reads every n-th scan of a CARMEN log or of a bag, as a step of the tool.
 * \throws InputFileException as loadCarmenLog and loadBagScans */
LogObservations
readScans(const RectificationOptions& options, StageLog& log);

} // namespace pcl::acmap
