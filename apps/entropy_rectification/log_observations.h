#pragma once

#include "stage_log.h"

#include <pcl/core/planar_scan.h>
#include <pcl/pipeline/sequence_consolidation.h>

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief The scans of a log, to be rectified. */
struct LogObservations : ConsolidatedObservations {
  std::vector<PlanarScan> scans;
  std::size_t points = 0; ///< echoes
};

/** \brief Reads every n-th scan of a CARMEN log, as a step of the tool.
 * \throws InputFileException as loadCarmenLog */
LogObservations
readScans(const std::string& path, std::size_t every, StageLog& log);

} // namespace pcl::acmap
