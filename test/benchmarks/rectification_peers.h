#pragma once

#include "rectification_runs.h"

#include <utility>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Pairs of observations, the earlier one first. */
using ObservationPairs = std::vector<std::pair<std::size_t, std::size_t>>;

/** \brief Consolidated observations, sensor frames. */
using PeerClouds = std::vector<PointCloud<PointNormal>::Ptr>;

/** \brief Result of a PCL method. */
struct PeerRun {
  std::vector<Eigen::Isometry3d> poses; ///< T_map_sensor, the first one as given
  double seconds = 0;                   ///< CPU time on one thread
};

/** \brief Neighbours, and pairs that truly observe the same place at different
 * times. */
ObservationPairs
truePairs(const RectificationMap& map);

/** \brief registration::LUM as in PCL's tool: alternates five times between nearest
 * neighbours within 0.3 m in the given pairs and solving for the poses. */
PeerRun
runLum(const PeerClouds& clouds,
       const std::vector<Eigen::Isometry3d>& given,
       const ObservationPairs& pairs);

/** \brief registration::ELCH with the first and the last observation as the loop ends,
 * which are registered by ICP with correspondences within 0.3 m. */
PeerRun
runElch(const PeerClouds& clouds, const std::vector<Eigen::Isometry3d>& given);

} // namespace pcl::acmap::bench
