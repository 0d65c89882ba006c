#pragma once

#include "tool.h"

#include <pcl/core/trajectory.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief What is to be rectified, from whichever input. */
struct MapObservations {
  Trajectory trajectory;          ///< as it came
  std::vector<std::string> files; ///< names of the observations; none of a log

  /** \brief The points by which observations are compared, each with its normal (NaN
   * where it has none); sensor frame, metres. */
  std::vector<PointCloud<PointNormal>::Ptr> clouds;

  /** \brief How much surface each of them stands for. */
  std::vector<std::vector<float>> weights;

  /** \brief An observation as it was measured; sensor frame, metres.
   * \throws InputFileException when it can no longer be read */
  std::function<std::shared_ptr<const PointCloudFile>(std::size_t)> load;

  std::size_t points = 0; ///< finite ones, as measured
  bool colored = false;   ///< has an observation that has colours
};

/** \brief Reads a folder and consolidates each observation for itself, as a step of the
 * tool.
 * \param[in] skip_broken observations that cannot be read are left out and named
 * \throws InputFileException when an observation cannot be read and none may be skipped, or
 * none has a pose */
MapObservations
readObservations(Tool& tool, const ObservationSequence& sequence, bool skip_broken);

/** \brief Reads each Nth scan of a CARMEN log, as a step of the tool.
 * \throws InputFileException as loadCarmenLog */
MapObservations
readScans(Tool& tool, const std::string& log, std::size_t every);

} // namespace pcl::acmap
