#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/progress.h>
#include <pcl/mapping/entropy_rectification_types.h>
#include <pcl/mapping/plane_adjustment_types.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl::acmap {

/** \brief Covariance of a small motion (rotation vector in radians, then translation in
 * metres) in the frame of the earlier view. */
using ActionCovariance = Eigen::Matrix<double, 6, 6>;

/** \throws BadArgumentException naming the value that is out of range */
ACMAP_EXPORT void
requireOdometryNoise(const OdometryNoise& noise);

/** \throws BadArgumentException unless it is finite, symmetric and positive definite */
ACMAP_EXPORT void
requireActionCovariance(const ActionCovariance& covariance);

/** \brief Relative pose of two views that have seen the same place. */
struct RevisitConstraint {
  std::size_t earlier, later; ///< numbers of the views, the smaller one first
  Eigen::Isometry3d T_earlier_later;
  /** Of small motions (tx, ty, tz in metres, rx, ry, rz in radians) in the frame of the
   * earlier view after T_earlier_later. */
  Eigen::Matrix<double, 6, 6> covariance;
};

/** \brief Settings of \ref adjustPlanes; see PlaneAdjustment. */
struct PlaneAdjustmentSettings {
  OdometryNoise odometry;
  /** One per action, from a view to the next; empty: from \ref odometry. */
  std::vector<ActionCovariance> action_covariances;
  bool estimate_odometry = true; ///< rescale the noise by the residuals
  std::vector<RevisitConstraint> revisits;
};

/** \brief The points of a view. */
struct AdjustedView {
  PointView points;              ///< metres, sensor's frame
  const float* sigmas = nullptr; ///< of the first point, metres along the ray; or none
  std::size_t sigma_stride = 0;  ///< bytes from one to the next
  std::size_t width = 0;         ///< pixels per row; 0: not organized
};

/** \brief Calls a function with a view, which is valid only during that call. */
using AdjustedViewReader =
    std::function<void(std::size_t, const std::function<void(const AdjustedView&)>&)>;

/** \brief Computes poses under which planes that several views see are thin.
 * \param[in] read gives access to each view; called from several threads, several times
 * \param[in] poses T_map_camera, in the order in which the views were made
 * \param[out] report counts, outcome and remarks are added
 * \return as many poses; the given ones if the outcome is not Adjusted
 * \throws BadArgumentException if the covariances differ in number from the actions, or
 * a revisit is of a view that does not exist
 * \throws CancelledException when the progress callback requested to stop */
ACMAP_EXPORT std::vector<Eigen::Isometry3d>
adjustPlanes(const AdjustedViewReader& read,
             const std::vector<Eigen::Isometry3d>& poses,
             const PlaneAdjustmentSettings& settings,
             const Progress& progress,
             PlaneAdjustmentReport& report);

} // namespace pcl::acmap
