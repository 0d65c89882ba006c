#pragma once

#include <pcl/common/transforms.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/point_fields.h>
#include <pcl/core/point_types.h>
#include <pcl/mapping/impl/map_entropy_kernel.h>
#include <pcl/mapping/impl/rectification_kernel.h>
#include <pcl/mapping/plane_adjustment.h>

#include <string>

namespace pcl {
namespace acmap {

/** \brief Has the point type a standard deviation along the ray? */
template <typename PointT>
inline constexpr bool has_sigma = traits::has_field<PointT, fields::sigma>::value;

template <typename PointT>
AdjustedView
adjustedViewOf(const PointCloud<PointT>& cloud)
{
  AdjustedView view;
  if (cloud.empty())
    return view;
  view.points = pointsOf(cloud);
  if constexpr (has_sigma<PointT>) {
    view.sigmas = &cloud.front().sigma;
    view.sigma_stride = sizeof(PointT);
  }
  view.width = cloud.isOrganized() ? cloud.width : 0;
  return view;
}

} // namespace acmap

template <typename PointT>
std::size_t
PlaneAdjustment<PointT>::addPointCloud(const PointCloudConstPtr& cloud,
                                       const Eigen::Isometry3d& pose)
{
  if (!cloud)
    throw BadArgumentException("a view needs a cloud");
  return addPointCloudLoader([cloud] { return cloud; }, pose);
}

template <typename PointT>
std::size_t
PlaneAdjustment<PointT>::addPointCloudLoader(Loader loader,
                                             const Eigen::Isometry3d& pose)
{
  acmap::requireMapPose(pose);
  loaders_.push_back(std::move(loader));
  given_.push_back(pose);
  poses_.push_back(pose);
  return poses_.size() - 1;
}

template <typename PointT>
void
PlaneAdjustment<PointT>::setPose(std::size_t number, const Eigen::Isometry3d& pose)
{
  acmap::requireObservation(number, poses_.size());
  acmap::requireMapPose(pose);
  given_[number] = pose;
  poses_[number] = pose;
}

template <typename PointT>
const Eigen::Isometry3d&
PlaneAdjustment<PointT>::getPose(std::size_t number) const
{
  acmap::requireObservation(number, poses_.size());
  return poses_[number];
}

template <typename PointT>
void
PlaneAdjustment<PointT>::clear()
{
  loaders_.clear();
  given_.clear();
  poses_.clear();
  settings_.action_covariances.clear();
  settings_.revisits.clear();
}

template <typename PointT>
void
PlaneAdjustment<PointT>::addRevisit(std::size_t earlier,
                                    std::size_t later,
                                    const Eigen::Isometry3d& T_earlier_later,
                                    const Eigen::Matrix<double, 6, 6>& covariance)
{
  acmap::requireObservation(later, poses_.size());
  if (earlier >= later)
    throw BadArgumentException("a revisit needs the earlier view first, not " +
                               std::to_string(earlier) + " and " +
                               std::to_string(later));
  acmap::requireMapPose(T_earlier_later);
  acmap::requireActionCovariance(covariance);
  settings_.revisits.push_back({earlier, later, T_earlier_later, covariance});
}

template <typename PointT>
void
PlaneAdjustment<PointT>::setOdometryNoise(const OdometryNoise& noise)
{
  acmap::requireOdometryNoise(noise);
  settings_.odometry = noise;
}

template <typename PointT>
void
PlaneAdjustment<PointT>::setActionCovariances(
    const std::vector<acmap::ActionCovariance>& covariances)
{
  for (const acmap::ActionCovariance& covariance : covariances)
    acmap::requireActionCovariance(covariance);
  settings_.action_covariances = covariances;
}

template <typename PointT>
void
PlaneAdjustment<PointT>::compute()
{
  if (loaders_.empty())
    PCL_THROW_EXCEPTION(InitFailedException, "no point cloud was added");
  PlaneAdjustmentReport report;
  const acmap::AdjustedViewReader read =
      [this](std::size_t i,
             const std::function<void(const acmap::AdjustedView&)>& use) {
        const PointCloudConstPtr cloud = loaders_[i]();
        use(cloud ? acmap::adjustedViewOf(*cloud) : acmap::AdjustedView());
      };
  std::vector<Eigen::Isometry3d> poses;
  acmap::withThreads(threads_, [&] {
    poses = acmap::adjustPlanes(
        read, given_, settings_, acmap::Progress(progress_), report);
  });
  poses_ = std::move(poses);
  report_ = std::move(report);
}

template <typename PointT>
Eigen::Affine3f
PlaneAdjustment<PointT>::getTransformation(std::size_t number) const
{
  return Eigen::Affine3f(getPose(number).template cast<float>().matrix());
}

template <typename PointT>
typename PlaneAdjustment<PointT>::PointCloudPtr
PlaneAdjustment<PointT>::getTransformedCloud(std::size_t number) const
{
  const Eigen::Affine3f pose = getTransformation(number);
  const PointCloudConstPtr cloud = loaders_[number]();
  PointCloudPtr result(new PointCloud);
  if (!cloud)
    return result;
  if constexpr (acmap::has_normal<PointT>)
    transformPointCloudWithNormals(*cloud, *result, pose);
  else
    transformPointCloud(*cloud, *result, pose);
  return result;
}

template <typename PointT>
typename PlaneAdjustment<PointT>::PointCloudPtr
PlaneAdjustment<PointT>::getConcatenatedCloud() const
{
  PointCloudPtr result(new PointCloud);
  for (std::size_t i = 0; i < loaders_.size(); ++i)
    *result += *getTransformedCloud(i);
  return result;
}

} // namespace pcl

#define PCL_INSTANTIATE_PlaneAdjustment(T) \
  template class ACMAP_EXPORT pcl::PlaneAdjustment<T>;
