#pragma once

#include "chain/evidence.h"
#include "chain/surface_blocks.h"

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief What laying surfaces upon each other tells. */
struct SurfaceTerm {
  Evidence evidence;
  double squares = 0; ///< m^2, weighted sum of squared distances
  double weights = 0; ///< of these

  /** \brief Metres, between point and plane. */
  double
  distance() const
  {
    return weights > 0 ? std::sqrt(squares / weights) : 0;
  }
};

/** \brief Distances from the source's points to the target's planes, each looked up
 * where the target's camera shows the point.
 * \param[in] reach metres; farther pairs are not of one surface */
SurfaceTerm
surfaceTerm(const SurfaceBlocks& source,
            const SurfaceBlocks& target,
            const Pinhole& target_pinhole,
            const Eigen::Isometry3d& T_target_source,
            double reach);

} // namespace pcl::acmap
