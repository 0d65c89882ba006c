#pragma once

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
  if (!cloud)
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

} // namespace acmap
} // namespace pcl

#define PCL_INSTANTIATE_PosedClouds(T, Pose, ReportT) \
  template class ACMAP_EXPORT pcl::acmap::PosedClouds<T, Pose, ReportT>;

#define PCL_INSTANTIATE_RegisteredClouds(T, ReportT) \
  PCL_INSTANTIATE_PosedClouds(                       \
      T,                                             \
      Eigen::Isometry3d,                             \
      ReportT) template class ACMAP_EXPORT pcl::acmap::RegisteredClouds<T, ReportT>;
