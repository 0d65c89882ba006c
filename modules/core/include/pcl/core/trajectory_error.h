#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/planar_pose.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace pcl {

/** \brief Error of an estimated motion with respect to the true one. \ingroup core */
struct MotionError {
  double translation = 0; ///< metres, norm of the translation of truth^-1 * found
  double rotation = 0;    ///< radians, angle of truth^-1 * found, in [0, pi]
  double length = 0;      ///< metres, translation of the true motion
};

/** \brief Error of one motion; both motions have the same source and target frames.
 * \throws BadArgumentException unless both are rigid \ingroup core */
ACMAP_EXPORT MotionError
motionError(const Eigen::Isometry3d& found, const Eigen::Isometry3d& truth);

/** \brief Relative pose error (RPE): statistics of the errors of many motions; NaN if
 * there are none. The median of an even number of values is the upper one.
 * \ingroup core */
struct RelativePoseError {
  std::size_t pairs = 0;
  double translation_rms = 0, translation_median = 0; ///< metres per pair
  double rotation_rms = 0, rotation_median = 0;       ///< radians per pair
  double rotation_worst = 0;                          ///< maximum, radians
  /** Metres per metre travelled: the sum of all errors over the sum of all lengths, and
   * the median over the pairs with a length of error over length. NaN if there is no
   * true motion. */
  double translation_per_metre = 0, translation_per_metre_median = 0;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const RelativePoseError& error, Visitor&& visit)
{
  visit({"pairs"}, error.pairs);
  visit({"translation_rms", "m"}, error.translation_rms);
  visit({"translation_median", "m"}, error.translation_median);
  visit({"rotation_rms", "rad"}, error.rotation_rms);
  visit({"rotation_median", "rad"}, error.rotation_median);
  visit({"rotation_worst", "rad"}, error.rotation_worst);
  visit({"translation_per_metre"}, error.translation_per_metre);
  visit({"translation_per_metre_median"}, error.translation_per_metre_median);
}

/** \brief Summarizes errors of motions, in any order. O(n). \ingroup core */
ACMAP_EXPORT RelativePoseError
summaryOf(const std::vector<MotionError>& errors);

/** \brief Relative pose error between poses i and i + step.
 * \param[in] found, truth corresponding poses T_map_camera; their map frames may differ
 * \throws BadArgumentException when they differ in number, one is not rigid, or step
 * is 0 \ingroup core */
ACMAP_EXPORT RelativePoseError
relativePoseError(const std::vector<Eigen::Isometry3d>& found,
                  const std::vector<Eigen::Isometry3d>& truth,
                  std::size_t step = 1);

/** \brief Absolute trajectory error (ATE): root mean square distance of the positions
 * from the true ones, metres. \ingroup core */
struct AbsoluteTrajectoryError {
  double unaligned = 0; ///< without alignment: the frames must be the same
  double aligned = 0;   ///< after the best rigid alignment, without scale
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const AbsoluteTrajectoryError& error, Visitor&& visit)
{
  visit({"trajectory_error", "m"}, error.unaligned);
  visit({"trajectory_error_aligned", "m"}, error.aligned);
}

/** \brief Absolute trajectory error in space, aligned by a rigid motion in 3D.
 * \param[in] found, truth corresponding poses T_map_camera
 * \throws BadArgumentException when they differ in number, there is none, or a position
 * is not finite \ingroup core */
ACMAP_EXPORT AbsoluteTrajectoryError
absoluteTrajectoryError(const std::vector<Eigen::Isometry3d>& found,
                        const std::vector<Eigen::Isometry3d>& truth);

/** \brief Absolute trajectory error on the floor, aligned by a rigid motion in the
 * plane: an alignment in 3D could flip a path that bends to the left onto one that
 * bends to the right.
 * \throws BadArgumentException when they differ in number, there is none, or a position
 * is not finite \ingroup core */
ACMAP_EXPORT AbsoluteTrajectoryError
absoluteTrajectoryError(const std::vector<PlanarPose>& found,
                        const std::vector<PlanarPose>& truth);

} // namespace pcl
