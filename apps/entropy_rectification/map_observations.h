#pragma once

#include "stage_log.h"

#include <pcl/core/planar_scan.h>
#include <pcl/pipeline/sequence_consolidation.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief The observations to be rectified, from any kind of input. */
struct MapObservations : ConsolidatedObservations {
  std::vector<PlanarScan> scans;  ///< of a log
  std::vector<std::string> files; ///< names of the observations; empty for a log

  /** \brief Loads an observation as measured; sensor frame, metres.
   * \throws InputFileException when it can no longer be read */
  std::function<std::shared_ptr<const PointCloudFile>(std::size_t)> load;

  std::size_t points = 0; ///< finite measured points
  bool colored = false;   ///< true if an observation has colours
};

/** \brief Consolidates each observation of a sequence separately, as a step of the tool.
 * \param[in] raw takes the points as they were measured instead
 * \param[in] skip_broken observations that cannot be read are left out and reported
 * \throws InputFileException when an observation cannot be read and none may be
 * skipped, or none has a pose */
MapObservations
readObservations(const ObservationSequence& sequence,
                 bool raw,
                 bool skip_broken,
                 const RunControls& controls,
                 StageLog& log);

/** \brief Reads every n-th scan of a CARMEN log, as a step of the tool.
 * \throws InputFileException as loadCarmenLog */
MapObservations
readScans(const std::string& path, std::size_t every, StageLog& log);

} // namespace pcl::acmap
