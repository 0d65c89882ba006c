#pragma once

#include "chain/appearance_level.h"
#include "chain/evidence.h"
#include "chain/pinhole.h"

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief The target's brightness as the source's light would show it: gain * value +
 * offset. */
struct LightChange {
  double gain = 1;
  double offset = 0; ///< grey levels
};

/** \brief The change of light that gives what both see the same mean and contrast. */
LightChange
lightChange(const AppearanceLevel& source,
            const AppearanceLevel& target,
            const Pinhole& target_pinhole,
            const Eigen::Isometry3d& T_target_source);

/** \brief Differences in brightness between the source's pixels and where the target's
 * camera shows their points. */
Evidence
appearanceTerm(const AppearanceLevel& source,
               const AppearanceLevel& target,
               const Pinhole& target_pinhole,
               const Eigen::Isometry3d& T_target_source,
               const LightChange& light);

} // namespace pcl::acmap
