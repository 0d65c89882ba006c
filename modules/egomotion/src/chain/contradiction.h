#pragma once

#include "chain/egomotion_view.h"

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief How much of what one view saw the other denies, as a share of what it can
 * tell about: pieces of surface that would stand well before what the other saw there.
 * The larger of both shares; a right motion has next to none. */
double
contradictedShare(const EgomotionView& source,
                  const EgomotionView& target,
                  const Eigen::Isometry3d& T_target_source);

} // namespace pcl::acmap
