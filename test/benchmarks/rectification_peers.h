#pragma once

#include "rectification_maps.h"

#include <utility>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Pairs of observations, the earlier one first. */
using ObservationPairs = std::vector<std::pair<std::size_t, std::size_t>>;

/** \brief What a method of PCL found. */
struct PeerRun {
  std::vector<PlanarPose> poses;
  double seconds = 0; ///< CPU, on one thread
};

/** \brief Neighbours, and those that truly look at the same place at another time. */
ObservationPairs
truePairs(const RectificationMap& map);

/** \brief registration::LUM, used as PCL's tool does: in turn it finds nearest neighbours
 * within 0.3 m in the given pairs and solves for the poses, five times. */
PeerRun
runLum(const RectificationMap& map,
       const std::vector<PlanarPose>& given,
       const ObservationPairs& pairs);

/** \brief registration::ELCH with the first and the last observation as ends of the loop,
 * closed by ICP of correspondences within 0.3 m. */
PeerRun
runElch(const RectificationMap& map, const std::vector<PlanarPose>& given);

} // namespace pcl::acmap::bench
