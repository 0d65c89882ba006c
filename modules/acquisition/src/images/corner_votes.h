#pragma once

#include "smooth_image.h"

#include <pcl/core/rig_calibration.h>

#include <array>
#include <cstddef>

namespace pcl::acmap {

/** \brief Number of corners of a reference image that were found again. */
struct CornerVotes {
  std::size_t corners = 0; ///< that were searched for
  std::size_t found = 0;   ///< in both neighbours, at exactly one depth

  double
  share() const
  {
    return corners > 0 ? static_cast<double>(found) / static_cast<double>(corners) : 0;
  }
};

/** \brief Searches for corners of the reference image at the positions in the neighbour
 * images that the calibration predicts for depths from 0.3 m to infinity. A corner that
 * is so far away that it shows no parallax does not count as found.
 * \param[in] images by \ref RigCamera
 * \param[in] corners of the reference image */
CornerVotes
countVotes(const std::array<const SmoothImage*, 3>& images,
           const std::vector<cv::Point>& corners,
           const RigCalibration& calibration);

} // namespace pcl::acmap
