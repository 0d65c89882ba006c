#pragma once

#include "../entropy/planar_motion.h"

#include <pcl/core/planar_pose.h>
#include <pcl/mapping/impl/rectification_kernel.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief An observation as a planar scan: beams at equal steps of the angle from z towards
 * x, in the levelled frame. */
struct BeamScan {
  /** \brief An echo. */
  struct Echo {
    Eigen::Vector2d place, normal; ///< x and z; the normal towards the sensor
    bool is_on_line = false;       ///< has it a normal?
  };

  double first_angle = 0, step = 1; ///< radians
  std::vector<double> ranges;       ///< metres, one a beam; 0: no echo
  std::vector<int> echo_of;         ///< one a beam, index of its echo; -1: none
  std::vector<Echo> echoes;         ///< in the order of their beams

  /** \brief In the direction of which beam a place lies, with the fraction of the way to the
   * next one; below 0, or beyond the last beam, outside of the sweep. */
  double
  directionOf(const Eigen::Vector2d& place) const;

  /** \brief The beam, and the fraction of the way to the next one, at a place; below 0
   * outside of the sweep. */
  double
  beamAt(const Eigen::Vector2d& place) const;
};

/** \brief Is an observation the scan of a planar laser: are all points at the height of the
 * sensor? */
bool
isPlanarScan(const LevelledPoints& seen);

/** \brief Makes the scan of an observation: of a view in space, that of its walls at the
 * height of the sensor. */
BeamScan
beamScanOf(const LevelledPoints& seen);

/** \brief How two scans agree, both ways: log likelihood ratio L and numbers of echoes,
 * for 180 beams (ALGORITHMS of the verdict: raw units). */
struct PairScore {
  double merit = 0;    ///< L
  double agree = 0;    ///< echoes on a surface of the other scan
  double through = 0;  ///< echoes through which the other scan has seen
  double occluded = 0; ///< echoes behind a surface of the other scan

  /** \brief Share of the agreeing echoes. */
  double
  quality() const
  {
    return agree / (agree + 1.5 * through + occluded + 1);
  }
};

/** \brief Compares scan \a j, placed in the frame of scan \a i, with it. */
PairScore
scoreOf(const BeamScan& i, const BeamScan& j, const PlanarPose& T_i_j);

} // namespace pcl::acmap
