#pragma once

#include "smooth_image.h"

#include <pcl/core/rig_calibration.h>

#include <array>
#include <cstddef>

namespace pcl::acmap {

/** \brief How many corners of a reference were found again. */
struct CornerVotes {
  std::size_t corners = 0; ///< that were looked for
  std::size_t found = 0;   ///< in both neighbours, for one depth and no other

  double
  share() const
  {
    return corners > 0 ? static_cast<double>(found) / static_cast<double>(corners) : 0;
  }
};

/** \brief Looks for corners of the reference where the calibration lets the neighbours
 * see them, for depths from 0.3 m to infinity; none that are too far to lie elsewhere in
 * a neighbour than in the reference count as found.
 * \param[in] images by \ref RigCamera
 * \param[in] corners of the reference */
CornerVotes
countVotes(const std::array<const SmoothImage*, 3>& images,
           const std::vector<cv::Point>& corners,
           const RigCalibration& calibration);

} // namespace pcl::acmap
