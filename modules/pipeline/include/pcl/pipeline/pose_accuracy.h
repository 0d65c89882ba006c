#pragma once

#include <pcl/core/cloud_rows.h>
#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/core/scratch_memory.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {

/** \brief Measures how accurate the poses of observations are, by the planes that several of
 * them saw: the mean distance of the points of each observation from a plane is what its pose
 * (and its sensor) is wrong by, across this plane.
 *
 * For all pairs of observations of a plane with 200 points each, half of the squared difference
 * of these means is a sample of a variogram, pose^2 + (drift * h)^2 / 2 at the distance h between
 * the positions. Both are fitted by weighted least squares over eight bins of h. The noise of the means is
 * subtracted. Points of one plane beyond the tolerance of its growth are not on it, so poses that
 * err by more than that are told too well.
 * \param[in] cloud points with the field `view`, metres, in the map frame
 * \param[in] labels plane of each point, -1 for none
 * \param[in] viewpoints of the observations, metres
 * \return not known with fewer than 8 pairs of observations \ingroup pipeline */
ACMAP_EXPORT MapAccuracy
measurePoseAccuracy(const CloudRows& cloud,
                    const PointLabels& labels,
                    const std::vector<PlanePatch>& planes,
                    const std::vector<Eigen::Vector3f>& viewpoints);

/** \brief Gives a map this accuracy, and the covariances of its planes their part of the poses
 * (\ref acmap::poseVariance).
 * \param[in,out] map with covariances of independent noise alone, observations and trajectory
 * \ingroup pipeline */
ACMAP_EXPORT void
setAccuracy(const MapAccuracy& accuracy, CompactMap& map);

} // namespace pcl
