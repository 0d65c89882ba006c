#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/rigid_motion.h>
#include <pcl/core/stage_controls.h>
#include <pcl/filters/filter.h>
#include <pcl/memory.h>
#include <pcl/point_cloud.h>

#include <Eigen/Geometry>

#include <functional>
#include <type_traits>
#include <vector>

namespace pcl {
namespace acmap {

/** \brief Base of the classes that take observations with their poses: clouds in the frame
 * of the sensor, in the order in which they were made. \a Pose is a PlanarPose or an
 * Eigen::Isometry3d. */
template <typename PointT, typename Pose, typename ReportT>
class PosedClouds : public StageControls<ReportT> {
public:
  using PointCloud = pcl::PointCloud<PointT>;
  using PointCloudPtr = typename PointCloud::Ptr;
  using PointCloudConstPtr = typename PointCloud::ConstPtr;

  /** \brief A pose as it is given: in space, each type of Eigen for it. */
  using GivenPose =
      std::conditional_t<std::is_same_v<Pose, Eigen::Isometry3d>, RigidMotion, Pose>;

  /** \brief Adds an observation; the order must be that in which they were made.
   * \param[in] cloud in the sensor's frame; it must not be changed afterwards; points
   * and normals may be NaN
   * \param[in] pose T_map_camera
   * \param[in] weights weight of each point, such as the area or the length of wall that
   * it represents; empty: 1
   * \return its number
   * \throws BadArgumentException when the cloud is missing, the pose is not a rigid
   * motion, or the weights are not one per point, finite and >= 0 */
  std::size_t
  addPointCloud(const PointCloudConstPtr& cloud,
                const GivenPose& pose,
                const std::vector<float>& weights = {});

  /** \brief Sets the pose of an observation, from which the next run starts.
   * \throws BadArgumentException as \ref addPointCloud, or when there is no such
   * observation */
  void
  setPose(std::size_t number, const GivenPose& pose);

  /** \brief T_map_camera: the result after a run, the given pose before.
   * \throws BadArgumentException when there is no such observation */
  const Pose&
  getPose(std::size_t number) const;

  std::size_t
  getNumberOfPointClouds() const
  {
    return poses_.size();
  }

  /** \brief Removes all observations. */
  void
  clear();

protected:
  using Loader = std::function<PointCloudConstPtr()>;

  std::size_t
  add(Loader loader, const GivenPose& pose, const std::vector<float>& weights);

  std::vector<Loader> loaders_;
  std::vector<std::vector<float>> weights_;
  std::vector<Pose> given_, poses_;
};

/** \brief The same for classes that find the poses under which clouds fit together, in
 * the shape of PCL's registration::LUM. */
template <typename PointT, typename ReportT>
class RegisteredClouds : public PosedClouds<PointT, Eigen::Isometry3d, ReportT> {
public:
  using typename PosedClouds<PointT, Eigen::Isometry3d, ReportT>::PointCloudPtr;

  /** \brief Same as getPose, in the type that PCL uses for transformations. */
  Eigen::Affine3f
  getTransformation(std::size_t number) const;

  /** \brief Returns an observation in the frame of the map. */
  PointCloudPtr
  getTransformedCloud(std::size_t number) const;

  /** \brief Returns all observations in the frame of the map. */
  PointCloudPtr
  getConcatenatedCloud() const;
};

/** \brief The same with the calls of PCL's filters, for classes whose result is the map as
 * one cloud. An input cloud is an observation: its points are in the frame of its sensor,
 * and its `sensor_origin_` and `sensor_orientation_`, which a PCD file has as VIEWPOINT,
 * are its pose T_map_camera (metres).
 * \code
 * for (const auto& cloud : clouds) {
 *   registration.setInputCloud (cloud);
 *   registration.addPointsFromInputCloud ();
 * }
 * registration.filter (map);
 * \endcode */
template <typename PointT, typename ReportT>
class RegisteringFilter : public Filter<PointT>,
                          public RegisteredClouds<PointT, ReportT> {
  using Observations = RegisteredClouds<PointT, ReportT>;

public:
  using typename Observations::PointCloud;
  using typename Observations::PointCloudConstPtr;
  using typename Observations::PointCloudPtr;

  /** \brief Sets the next observation; it must not be changed afterwards.
   * \throws InitFailedException without a cloud */
  void
  setInputCloud(const PointCloudConstPtr& cloud) override;

  /** \brief Adds the input cloud, or its indices if they are set, as the last observation,
   * unless it is that already: the same cloud with the same indices is added once.
   * \return its number
   * \throws InitFailedException without an input cloud, or with indices out of range
   * \throws BadArgumentException when its pose is not finite */
  std::size_t
  addPointsFromInputCloud();

  /** \brief Adds the input cloud, if there is one, as \ref addPointsFromInputCloud does,
   * finds the poses of all observations that were added, in whatever way, and gives the
   * map: what compute and getConcatenatedCloud give. Nothing is removed but what the
   * indices leave out; \ref clear begins another map.
   * \param[out] output the map, in its own frame (its sensor is at the origin); may be the
   * input cloud
   * \throws InitFailedException without an observation, and as addPointsFromInputCloud
   * \throws what compute throws; the output is unchanged */
  void
  filter(PointCloud& output);

  /** \brief Finds the poses of the observations. */
  virtual void
  compute() = 0;

  /** \brief Removes all observations; an input cloud stays set. */
  void
  clear();

protected:
  void
  applyFilter(PointCloud& output) override;

private:
  PointCloudConstPtr added_input_; ///< the last one
  IndicesPtr added_indices_;
  std::size_t input_number_ = 0;
};

} // namespace acmap
} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/mapping/impl/posed_clouds.h>
#endif
