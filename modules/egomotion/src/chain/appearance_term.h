#pragma once

#include "chain/appearance_level.h"
#include "chain/evidence.h"

#include <pcl/core/pinhole.h>

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief Converts brightness of the target to the light of the source: gain * value +
 * offset. */
struct LightChange {
  double gain = 1;
  double offset = 0; ///< grey levels
};

/** \brief The change of light for which the common parts of both views have the same
 * mean and contrast. */
LightChange
lightChange(const AppearanceLevel& source,
            const AppearanceLevel& target,
            const Pinhole& target_pinhole,
            const Eigen::Isometry3d& T_target_source);

/** \brief Differences in brightness between the pixels of the source and the
 * projections of their points into the target. */
Evidence
appearanceTerm(const AppearanceLevel& source,
               const AppearanceLevel& target,
               const Pinhole& target_pinhole,
               const Eigen::Isometry3d& T_target_source,
               const LightChange& light);

} // namespace pcl::acmap
