#pragma once

#include <pcl/mapping/impl/rectification_kernel.h>

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief The error that a rectified map may still have, by an estimate that the entropy
 * has no part in: one linear step from the rectified poses, which weighs the odometry and
 * the distances of points from the walls of other observations.
 *
 * Points of observations that are at most eight apart are taken along their normals; what a
 * place that is seen again tells is not used, since it may be another one that looks alike. Along a direction that the walls of a pair do not show, such
 * as the axis of a corridor, the odometry alone remains, with its noise.
 * \param[in] poses of the map
 * \param[in] given poses of the odometry
 * \param[in] noise of the odometry
 * \param[in] bin_size of the entropy, metres
 * \return metres, 95 %: of the position of the pose that is known least, relative to the
 * first one; nothing without normals */
std::optional<double>
remainingError(const std::vector<LevelledPoints>& observations,
               const std::vector<PlanarPose>& poses,
               const std::vector<PlanarPose>& given,
               const OdometryNoise& noise,
               double bin_size);

} // namespace pcl::acmap
