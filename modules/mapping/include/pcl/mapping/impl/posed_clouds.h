#pragma once

#include <pcl/common/io.h>
#include <pcl/common/transforms.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/point_fields.h>
#include <pcl/mapping/impl/map_entropy_kernel.h>
#include <pcl/mapping/impl/rectification_kernel.h>
#include <pcl/mapping/posed_clouds.h>

#include <utility>

namespace pcl {
namespace acmap {

inline const Eigen::Isometry3d&
checkedPose(const RigidMotion& pose)
{
  return requirePlace(pose).get();
}

inline const PlanarPose&
checkedPose(const PlanarPose& pose)
{
  requirePlanarPose(pose);
  return pose;
}

template <typename PointT, typename Pose, typename ReportT>
std::size_t
PosedClouds<PointT, Pose, ReportT>::addPointCloud(const PointCloudConstPtr& cloud,
                                                  const GivenPose& pose,
                                                  const std::vector<float>& weights)
{
  requireCloud<BadArgument>(cloud);
  checkedPose(pose);
  requirePointWeights(weights, cloud->size());
  return add([cloud] { return cloud; }, pose, weights);
}

template <typename PointT, typename Pose, typename ReportT>
std::size_t
PosedClouds<PointT, Pose, ReportT>::add(Loader loader,
                                        const GivenPose& pose,
                                        const std::vector<float>& weights)
{
  const Pose& checked = checkedPose(pose);
  loaders_.push_back(std::move(loader));
  weights_.push_back(weights);
  given_.push_back(checked);
  poses_.push_back(checked);
  return poses_.size() - 1;
}

template <typename PointT, typename Pose, typename ReportT>
void
PosedClouds<PointT, Pose, ReportT>::setPose(std::size_t number, const GivenPose& pose)
{
  requireObservation(number, poses_.size());
  given_[number] = checkedPose(pose);
  poses_[number] = given_[number];
}

template <typename PointT, typename Pose, typename ReportT>
const Pose&
PosedClouds<PointT, Pose, ReportT>::getPose(std::size_t number) const
{
  requireObservation(number, poses_.size());
  return poses_[number];
}

template <typename PointT, typename Pose, typename ReportT>
void
PosedClouds<PointT, Pose, ReportT>::clear()
{
  loaders_.clear();
  weights_.clear();
  given_.clear();
  poses_.clear();
}

template <typename PointT, typename ReportT>
Eigen::Affine3f
RegisteredClouds<PointT, ReportT>::getTransformation(std::size_t number) const
{
  return Eigen::Affine3f(this->getPose(number).template cast<float>().matrix());
}

template <typename PointT, typename ReportT>
typename RegisteredClouds<PointT, ReportT>::PointCloudPtr
RegisteredClouds<PointT, ReportT>::getTransformedCloud(std::size_t number) const
{
  const Eigen::Affine3f pose = getTransformation(number);
  const auto cloud = this->loaders_[number]();
  PointCloudPtr result(new pcl::PointCloud<PointT>);
  if (!cloud || cloud->empty()) // PCL warns of a cloud without a width
    return result;
  if constexpr (has_normal<PointT>)
    transformPointCloudWithNormals(*cloud, *result, pose);
  else
    transformPointCloud(*cloud, *result, pose);
  return result;
}

template <typename PointT, typename ReportT>
typename RegisteredClouds<PointT, ReportT>::PointCloudPtr
RegisteredClouds<PointT, ReportT>::getConcatenatedCloud() const
{
  PointCloudPtr result(new pcl::PointCloud<PointT>);
  for (std::size_t i = 0; i < this->getNumberOfPointClouds(); ++i)
    *result += *getTransformedCloud(i);
  return result;
}

/** \brief T_map_camera as PCL keeps it in a cloud. */
template <typename PointT>
RigidMotion
sensorPoseOf(const PointCloud<PointT>& cloud)
{
  Eigen::Isometry3d pose(
      cloud.sensor_orientation_.template cast<double>().normalized());
  pose.translation() = cloud.sensor_origin_.template head<3>().template cast<double>();
  return pose;
}

template <typename PointT, typename ReportT>
void
RegisteringFilter<PointT, ReportT>::setInputCloud(const PointCloudConstPtr& cloud)
{
  requireGiven(cloud);
  Filter<PointT>::setInputCloud(cloud);
}

template <typename PointT, typename ReportT>
std::size_t
RegisteringFilter<PointT, ReportT>::addPointsFromInputCloud()
{
  const IndicesPtr indices = this->fake_indices_ ? nullptr : this->indices_;
  requireInput<PointT>(this->input_, indices.get());
  if (added_input_ == this->input_ && added_indices_ == indices)
    return input_number_;
  PointCloudConstPtr cloud = this->input_;
  if (indices) {
    const PointCloudPtr chosen(new PointCloud);
    copyPointCloud(*this->input_, *indices, *chosen);
    cloud = chosen;
  }
  input_number_ = this->add([cloud] { return cloud; }, sensorPoseOf(*cloud), {});
  added_input_ = this->input_;
  added_indices_ = indices;
  return input_number_;
}

template <typename PointT, typename ReportT>
void
RegisteringFilter<PointT, ReportT>::filter(PointCloud& output)
{
  applyFilter(output); // PCL's gives the map the pose of one sensor
}

template <typename PointT, typename ReportT>
void
RegisteringFilter<PointT, ReportT>::applyFilter(PointCloud& output)
{
  if (this->input_ || this->getNumberOfPointClouds() == 0)
    addPointsFromInputCloud();
  compute();
  const PointCloudPtr map = this->getConcatenatedCloud();
  if (&output == this->input_.get() &&
      !added_indices_) // the observation stays as it is
    this->loaders_[input_number_] =
        [kept = std::make_shared<const PointCloud>(std::move(output))] { return kept; };
  output = std::move(*map);
}

template <typename PointT, typename ReportT>
void
RegisteringFilter<PointT, ReportT>::clear()
{
  Observations::clear();
  added_input_.reset();
  added_indices_.reset();
}

} // namespace acmap
} // namespace pcl

#define PCL_INSTANTIATE_PosedClouds(T, Pose, ReportT) \
  template class ACMAP_EXPORT pcl::acmap::PosedClouds<T, Pose, ReportT>;

#define PCL_INSTANTIATE_RegisteredClouds(T, ReportT) \
  PCL_INSTANTIATE_PosedClouds(                       \
      T,                                             \
      Eigen::Isometry3d,                             \
      ReportT) template class ACMAP_EXPORT pcl::acmap::RegisteredClouds<T, ReportT>;

#define PCL_INSTANTIATE_RegisteringFilter(T, ReportT) \
  PCL_INSTANTIATE_RegisteredClouds(                   \
      T,                                              \
      ReportT) template class ACMAP_EXPORT pcl::acmap::RegisteringFilter<T, ReportT>;
