#pragma once

#include "chain/egomotion_view.h"
#include "chain/feature_pairs.h"

#include <pcl/egomotion/egomotion_types.h>

namespace pcl::acmap {

/** \brief A motion with its normal equations and the distances between the surfaces. */
struct RefinedMotion {
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();
  NormalEquations equations;
  /** \brief Covariance of the gradient of the equations for residuals whose errors are
   * correlated within tiles of the image and within kinds: sums of g g^T. */
  Matrix6 scatter = Matrix6::Zero();
  bool is_refined = false;
  std::size_t surface_pairs = 0;
  double surface_before = 0, surface_after = 0; ///< metres
};

/** \brief Aligns surfaces and brightness of two views, together with the features, from
 * coarse to fine. The result is accepted if the surfaces are not farther apart and the
 * total fits better.
 * \param[in] refines if false, only the equations of the features are computed */
RefinedMotion
refinedMotion(const EgomotionView& source,
              const EgomotionView& target,
              const std::vector<FeaturePair>& features,
              const Eigen::Isometry3d& T_target_source,
              MotionModel model,
              bool refines);

} // namespace pcl::acmap
