#pragma once

#include "chain/egomotion_view.h"
#include "chain/feature_pairs.h"

#include <pcl/egomotion/egomotion_types.h>

namespace pcl::acmap {

/** \brief A motion with all that was laid upon each other under it. */
struct RefinedMotion {
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();
  NormalEquations equations;
  bool is_refined = false;
  std::size_t surface_pairs = 0;
  double surface_before = 0, surface_after = 0; ///< metres
};

/** \brief Lays surfaces and brightness of two views upon each other, together with the
 * features, coarse to fine; takes the result where the surfaces are nearer then, and
 * all together fits better.
 * \param[in] refines false: only tell what the features are worth */
RefinedMotion
refinedMotion(const EgomotionView& source,
              const EgomotionView& target,
              const std::vector<FeaturePair>& features,
              const Eigen::Isometry3d& T_target_source,
              MotionModel model,
              bool refines);

} // namespace pcl::acmap
