#pragma once

#include "tool.h"

#include <pcl/core/trajectory.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief The observations to be rectified, from any kind of input. */
struct MapObservations {
  Trajectory trajectory;          ///< from the input
  std::vector<std::string> files; ///< names of the observations; empty for a log

  /** \brief The points by which observations are compared, each with its normal (NaN if
   * there is none); sensor frame, metres. */
  std::vector<PointCloud<PointNormal>::Ptr> clouds;

  /** \brief Surface area that each of these points represents. */
  std::vector<std::vector<float>> weights;

  /** \brief Loads an observation as measured; sensor frame, metres.
   * \throws InputFileException when it can no longer be read */
  std::function<std::shared_ptr<const PointCloudFile>(std::size_t)> load;

  std::size_t points = 0; ///< finite measured points
  bool colored = false;   ///< true if an observation has colours
};

/** \brief Reads a folder and consolidates each observation separately, as a step of the
 * tool.
 * \param[in] skip_broken observations that cannot be read are left out and reported
 * \throws InputFileException when an observation cannot be read and none may be
 * skipped, or none has a pose */
MapObservations
readObservations(Tool& tool, const ObservationSequence& sequence, bool skip_broken);

/** \brief Reads every n-th scan of a CARMEN log, as a step of the tool.
 * \throws InputFileException as loadCarmenLog */
MapObservations
readScans(Tool& tool, const std::string& log, std::size_t every);

/** \brief The normal of floors and ceilings in the map, with y > 0: the most frequent
 * direction among the normals within 45 degrees of y. Nothing if only few points have
 * such a normal. */
std::optional<Eigen::Vector3d>
floorNormalOf(const MapObservations& observations);

} // namespace pcl::acmap
