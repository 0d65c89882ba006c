#pragma once

#include <pcl/core/export.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/progress.h>
#include <pcl/mapping/entropy_rectification_types.h>
#include <pcl/mapping/impl/rectification_kernel.h>
#include <pcl/mapping/map_verdict_types.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Judges poses by an estimate of its own; see MapVerdict.
 * \param[in] given the odometry, one pose an observation
 * \param[in] judged as many poses
 * \param[out] report its remarks and seconds are kept
 * \throws CancelledException when the progress callback requested to stop */
ACMAP_EXPORT void
judgeMap(const std::vector<LevelledPoints>& observations,
         const std::vector<PlanarPose>& given,
         const std::vector<PlanarPose>& judged,
         const OdometryNoise& noise,
         std::uint64_t seed,
         const Progress& progress,
         MapVerdictReport& report);

} // namespace pcl::acmap
