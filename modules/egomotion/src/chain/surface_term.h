#pragma once

#include "chain/evidence.h"
#include "chain/surface_blocks.h"

#include <pcl/core/pinhole.h>

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief Residuals between aligned surfaces. */
struct SurfaceTerm {
  Evidence evidence;
  double squares = 0; ///< m^2, weighted sum of squared distances
  double weights = 0; ///< sum of the weights

  /** \brief RMS distance between point and plane, metres. */
  double
  distance() const
  {
    return weights > 0 ? std::sqrt(squares / weights) : 0;
  }
};

/** \brief Distances from the points of the source to the planes of the target at their
 * projections into the target's camera.
 * \param[in] reach metres; pairs that are farther apart are not of the same surface */
SurfaceTerm
surfaceTerm(const SurfaceBlocks& source,
            const SurfaceBlocks& target,
            const Pinhole& target_pinhole,
            const Eigen::Isometry3d& T_target_source,
            double reach);

} // namespace pcl::acmap
