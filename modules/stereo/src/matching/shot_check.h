#pragma once

#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/stereo/matched_disparity.h>

#include <string>

namespace pcl::acmap {

/** \brief Rejects a rig that has invalid values or no neighbours, or whose baselines
 * differ by more than a factor of 16, because no range of disparities is suitable for
 * both.
 * \throws BadArgumentException naming value and legal range */
void
requireStereoRig(const TrinocularRig& rig);

/** \brief Rejects a shot that does not belong to the rig.
 * \throws BadArgumentException naming the camera and what is wrong */
void
requireShotOf(const TrinocularRig& rig, const TrinocularFrame& shot);

} // namespace pcl::acmap
