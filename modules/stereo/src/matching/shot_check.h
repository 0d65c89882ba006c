#pragma once

#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/stereo/matched_disparity.h>

#include <string>

namespace pcl::acmap {

/** \brief "640 x 480 pixels". */
std::string
sizeText(int width, int height);

/** \brief Refuses a rig that no camera can have, that has no neighbours, or whose baselines
 * differ more than 16 times: no disparities serve both then.
 * \throws BadArgumentException naming value and legal range */
void
requireStereoRig(const TrinocularRig& rig);

/** \brief Refuses a shot that is not one of the rig.
 * \throws BadArgumentException naming the camera and what is wrong */
void
requireShotOf(const TrinocularRig& rig, const TrinocularFrame& shot);

} // namespace pcl::acmap
