#pragma once

#include "stereo_input.h"

#include <pcl/simulation/simulated_truth.h>
#include <pcl/stereo/matched_disparity.h>

#include <vector>

namespace pcl::acmap::bench {

/** \brief Statistics of a plane fit to the points of a wall. */
struct WallFit {
  double rms = 0;      ///< metres, distances of the points from the plane
  double expected = 0; ///< metres, the value expected from the standard deviations
  double offset = 0;   ///< metres, distance from the true plane at the centroid of the
                       ///< points
  double turn = 0;     ///< rad, between their normals
};

/** \brief Fits a plane to the matched pixels of surface 0 within 1 px of the truth.
 * \param[in] mask pixels that are used */
WallFit
fitWall(const MatchedDisparity& found,
        const SimulatedTruth& truth,
        const PixelMask& mask,
        const TrinocularRig& rig);

/** \brief The means of several fits. */
WallFit
meanOf(const std::vector<WallFit>& fits);

} // namespace pcl::acmap::bench
