#pragma once

#include <pcl/core/export.h>
#include <pcl/core/planar_pose.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace pcl {

/** \brief How far a motion that was found is from the true one. \ingroup core */
struct MotionError {
  double translation = 0; ///< metres, length of truth^-1 * found
  double rotation = 0;    ///< radians, its angle, in [0, pi]
  double length = 0;      ///< metres, of the true motion
};

/** \brief Error of one motion; both take points of the same frame into the same frame.
 * \throws BadArgumentException unless both are rigid \ingroup core */
ACMAP_EXPORT MotionError
motionError(const Eigen::Isometry3d& found, const Eigen::Isometry3d& truth);

/** \brief Relative pose error (RPE): errors of many motions; NaN without any. A median is
 * the upper one of an even number. \ingroup core */
struct RelativePoseError {
  std::size_t pairs = 0;
  double translation_rms = 0, translation_median = 0; ///< metres a pair
  double rotation_rms = 0, rotation_median = 0;       ///< radians a pair
  double rotation_worst = 0;                          ///< radians
  /** Metres a metre travelled: all errors over all lengths, and the median of a pair's
   * error over its length, where it has one. NaN where the truth stands still. */
  double translation_per_metre = 0, translation_per_metre_median = 0;
};

/** \brief Sums up errors of motions, in any order. O(n). \ingroup core */
ACMAP_EXPORT RelativePoseError
summaryOf(const std::vector<MotionError>& errors);

/** \brief Relative pose error between poses i and i + step.
 * \param[in] found, truth T_map_camera, in their order: the i-th belongs to the i-th; their
 * maps may differ
 * \throws BadArgumentException when they differ in number, one is not rigid, or step is 0
 * \ingroup core */
ACMAP_EXPORT RelativePoseError
relativePoseError(const std::vector<Eigen::Isometry3d>& found,
                  const std::vector<Eigen::Isometry3d>& truth,
                  std::size_t step = 1);

/** \brief Absolute trajectory error (ATE): distances of places from the true ones, root
 * mean squares, metres. \ingroup core */
struct AbsoluteTrajectoryError {
  double unaligned = 0; ///< as they are: their frames must be the same
  double aligned = 0;   ///< after the rigid motion that fits best, without scale
};

/** \brief Absolute trajectory error in space, aligned by turns and shifts of space.
 * \param[in] found, truth T_map_camera, in their order: the i-th belongs to the i-th
 * \throws BadArgumentException when they differ in number, there is none, or a place is
 * not finite \ingroup core */
ACMAP_EXPORT AbsoluteTrajectoryError
absoluteTrajectoryError(const std::vector<Eigen::Isometry3d>& found,
                        const std::vector<Eigen::Isometry3d>& truth);

/** \brief The same on the floor, aligned within it: in space, a path that bends to the
 * left would be turned over onto one that bends to the right.
 * \throws BadArgumentException when they differ in number, there is none, or a place is
 * not finite \ingroup core */
ACMAP_EXPORT AbsoluteTrajectoryError
absoluteTrajectoryError(const std::vector<PlanarPose>& found,
                        const std::vector<PlanarPose>& truth);

} // namespace pcl
