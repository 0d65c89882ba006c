#pragma once

#include "stereo_input.h"

#include <pcl/simulation/simulated_truth.h>
#include <pcl/stereo/matched_disparity.h>

#include <vector>

namespace pcl::acmap::bench {

/** \brief What a plane through the points of a wall tells. */
struct WallFit {
  double rms = 0;      ///< metres, points off the plane
  double expected = 0; ///< metres, the same as the standard deviations have it
  double offset = 0; ///< metres, the plane off the true one in the middle of the points
  double turn = 0;   ///< rad, between their normals
};

/** \brief Fits a plane to the matched pixels of surface 0 that are within 1 px of the
 * truth.
 * \param[in] mask pixels that count */
WallFit
fitWall(const MatchedDisparity& found,
        const SimulatedTruth& truth,
        const PixelMask& mask,
        const TrinocularRig& rig);

/** \brief The means of all. */
WallFit
meanOf(const std::vector<WallFit>& fits);

} // namespace pcl::acmap::bench
