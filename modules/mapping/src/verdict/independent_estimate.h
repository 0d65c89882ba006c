#pragma once

#include "pose_draws.h"
#include "revisits.h"

#include <pcl/mapping/impl/rectification_kernel.h>
#include <pcl/mapping/map_verdict_types.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Are the observations scans of planar lasers? */
bool
areScans(const std::vector<LevelledPoints>& observations);

/** \throws BadArgumentException unless there is a finite pose for each observation */
void
requirePoses(const std::vector<PlanarPose>& poses, std::size_t observations);

/** \brief An estimate of a trajectory from scans and odometry alone, with an honest
 * covariance, which judges other estimates. It uses neither entropy nor what a
 * rectification found. */
class IndependentEstimate {
public:
  /** \param[in] given the odometry
   * \param[in] assumed its noise
   * \throws BadArgumentException as \ref requirePoses
   * \throws CancelledException when the progress callback requested to stop */
  IndependentEstimate(const std::vector<LevelledPoints>& observations,
                      const std::vector<PlanarPose>& given,
                      const OdometryNoise& assumed,
                      std::uint64_t seed,
                      const Progress& progress);

  /** \brief Errors of the odometry as the scans show them. */
  const MeasuredOdometry&
  odometry() const
  {
    return odometry_;
  }

  /** \brief Judges other poses of the same observations.
   * \throws BadArgumentException as \ref requirePoses */
  MapVerdictReport
  judge(const std::vector<PlanarPose>& poses) const;

  /** \brief Judges the given poses alone, not in comparison with others. */
  MapVerdictReport
  judgeGiven() const;

private:
  std::vector<PlanarPose> given_;
  MeasuredOdometry odometry_;
  PoseDraws chain_; ///< without revisits
  PoseDraws drawn_;
  Revisits revisits_;
};

} // namespace pcl::acmap
