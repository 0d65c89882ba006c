#pragma once

#include "step_chain.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Trajectories that are drawn from an estimate, and their mean. */
struct PoseDraws {
  std::vector<PlanarPose> mean;
  std::vector<std::vector<PlanarPose>> draws;

  /** \brief Relative pose of two scans in a draw. */
  PlanarPose
  between(std::size_t draw, std::size_t from, std::size_t to) const;

  /** \brief Covariance of the relative pose about that of the mean. */
  Eigen::Matrix3d
  covarianceBetween(std::size_t from, std::size_t to) const;

  /** \brief A draw as far as \a times the distance from the mean. */
  std::vector<PlanarPose>
  widened(std::size_t draw, double times) const;
};

/** \brief Solves the pose graph of steps and revisits, and draws from its posterior: each
 * draw disturbs all measurements, and has an error of the scale and of the turns that is
 * common to all steps. */
PoseDraws
drawPoses(const StepChain& chain,
          const std::vector<PoseLink>& revisits,
          std::uint64_t seed);

} // namespace pcl::acmap
