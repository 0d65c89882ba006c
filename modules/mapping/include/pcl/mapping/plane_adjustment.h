#pragma once

#include <pcl/core/build_config.h>
#include <pcl/mapping/impl/plane_adjustment_kernel.h>
#include <pcl/mapping/plane_adjustment_types.h>
#include <pcl/mapping/posed_clouds.h>
#include <pcl/memory.h>

#include <Eigen/Geometry>

#include <functional>
#include <vector>

namespace pcl {

/** \brief Adjusts the poses of all views of a map at once, in six degrees of freedom, so
 * that planes which several views see become thin. Follows the rectification of Section
 * II-B.2 of "Active Stereo Based Compact Mapping", which leaves heights and tilts as they
 * are. In the shape of PCL's registration::LUM.
 *
 * Views are cut into planar pieces, each with its noise. Pieces of several views are
 * associated to a plane where the uncertainty of the relative poses permits it: certain
 * pairs first; revisits follow when the rest of the map has become stiff. The poses
 * minimise the sum over the planes of the smallest sum of squared distances, in units of
 * the noise (point clusters as in Liu, Liu and Zhang, "Efficient and Consistent Bundle
 * Adjustment on Lidar Point Clouds", 2023; the planes are eliminated), plus the squared
 * residuals of the odometry, in standard deviations: without them views slide along a
 * corridor. Systematic errors of the sensor, its noise where points have no `sigma`, and
 * the scale of the odometry's noise are estimated from the residuals.
 *
 * The poses are unchanged if the planes fit the given ones within noise, and if rays
 * contradict the adjusted poses more than the given ones. The first pose is fixed.
 *
 * Clouds are organized views of a camera, or others such as laser scans; the field
 * `sigma` (metres along the ray) is used if PointT has it. Units are metres and radians.
 * The time is O(n log n) for n points, plus O(views) for a path that does not stay in one
 * place: the normal equations are sparse. The result is bitwise the same for any number
 * of threads.
 * \code
 * pcl::PlaneAdjustment<pcl::PointXYZRGBSigma> adjustment;
 * for (std::size_t i = 0; i < clouds.size (); ++i)
 *   adjustment.addPointCloud (clouds[i], T_map_camera[i]);
 * adjustment.compute ();
 * std::cout << adjustment.getReport ().reason << '\n';
 * \endcode
 * \ingroup mapping */
template <typename PointT>
class PlaneAdjustment : public acmap::RegisteringFilter<PointT, PlaneAdjustmentReport> {
  using Base = acmap::RegisteringFilter<PointT, PlaneAdjustmentReport>;

public:
  using Ptr = shared_ptr<PlaneAdjustment<PointT>>;
  using ConstPtr = shared_ptr<const PlaneAdjustment<PointT>>;
  using typename Base::PointCloudConstPtr;

  /** \brief Returns a view; it is called from several threads. */
  using typename Base::Loader;

  /** \brief Adds a view; the order must be that in which they were made.
   * \param[in] cloud in the sensor's frame; it must not be changed afterwards; points
   * may be NaN
   * \param[in] pose T_map_camera
   * \return its number
   * \throws BadArgumentException when the cloud is missing or the pose is not a rigid
   * motion */
  std::size_t
  addPointCloud(const PointCloudConstPtr& cloud, const acmap::RigidMotion& pose);

  /** \brief Adds a view that is loaded whenever it is needed, so that not all views are
   * in memory at once.
   * \throws BadArgumentException when the pose is not a rigid motion */
  std::size_t
  addPointCloudLoader(Loader loader, const acmap::RigidMotion& pose);

  /** \brief Removes all views, the covariances of their actions and the revisits. */
  void
  clear();

  /** \brief Sets the expected errors of the odometry: the standard deviations hold for
   * each of the three components of a translation and of a rotation.
   * \throws BadArgumentException naming the value */
  void
  setOdometryNoise(const OdometryNoise& noise);

  const OdometryNoise&
  getOdometryNoise() const
  {
    return settings_.odometry;
  }

  /** \brief Sets the covariance of each action, from a view to the next: rotation vector
   * in radians, then translation in metres, in the frame of the earlier view. Empty
   * (default): those of \ref setOdometryNoise.
   * \throws BadArgumentException when one is not symmetric and positive definite */
  void
  setActionCovariances(const std::vector<acmap::ActionCovariance>& covariances);

  const std::vector<acmap::ActionCovariance>&
  getActionCovariances() const
  {
    return settings_.action_covariances;
  }

  /** \brief Adds the relative pose of two views that have seen the same place, such as
   * RevisitDetection finds, so that surfaces which drift has moved apart are associated.
   *
   * It is dropped if it contradicts the odometry, other revisits or the planes by more
   * than three standard deviations; and all are, if the poses that they lead to are
   * refused because of the rays. The report tells how many.
   * \param[in] earlier, later numbers of views, the smaller one first
   * \param[in] T_earlier_later maps points of the second into the frame of the first
   * \param[in] covariance of small motions (tx, ty, tz in metres, rx, ry, rz in radians)
   * in the frame of the first after T_earlier_later, as EgomotionEstimate::covariance
   * \throws BadArgumentException unless \a earlier < \a later and both exist, when the
   * pose is not a rigid motion or the covariance not positive definite */
  void
  addRevisit(std::size_t earlier,
             std::size_t later,
             const acmap::RigidMotion& T_earlier_later,
             const Eigen::Matrix<double, 6, 6>& covariance);

  std::size_t
  getNumberOfRevisits() const
  {
    return settings_.revisits.size();
  }

  /** \brief Rescales the noise of the odometry so that its residuals agree with it
   * (default true); the factor is in the report. */
  void
  setEstimateOdometryNoise(bool estimate)
  {
    settings_.estimate_odometry = estimate;
  }

  bool
  getEstimateOdometryNoise() const
  {
    return settings_.estimate_odometry;
  }

  /** \brief Adjusts the poses, always starting from the given ones, regardless of
   * earlier results.
   * \throws InitFailedException without a view
   * \throws BadArgumentException if the covariances are not one per action
   * \throws CancelledException when the progress callback requested to stop; nothing is
   * changed
   * \throws what a loader throws */
  void
  compute() override;

private:
  acmap::PlaneAdjustmentSettings settings_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/mapping/impl/plane_adjustment.hpp>
#endif
