#pragma once

#include <pcl/core/planar_pose.h>
#include <pcl/mapping/entropy_rectification_types.h>

#include <vector>

namespace pcl::acmap {

/** \brief The noise with other factors of its lengths and turns. */
OdometryNoise
scaled(OdometryNoise noise, double lengths, double turns);

/** \brief The odometry without the errors that neighbouring scans show in all of its steps;
 * the same poses if it errs no more than the search permits.
 * \param[in,out] noise as it is assumed; what is left
 * \param[in,out] report has a remark then; Refused, with the reason, if it errs so much that
 * no search can follow, as poses do that are read wrongly */
std::vector<PlanarPose>
mendedOdometry(const MeasuredOdometry& measured,
               const std::vector<PlanarPose>& given,
               OdometryNoise& noise,
               EntropyRectificationReport& report);

} // namespace pcl::acmap
