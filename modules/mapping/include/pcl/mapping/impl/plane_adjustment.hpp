#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/point_types.h>
#include <pcl/mapping/impl/posed_clouds.h>
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
                                       const acmap::RigidMotion& pose)
{
  acmap::requireCloud<acmap::BadArgument>(cloud);
  return addPointCloudLoader([cloud] { return cloud; }, pose);
}

template <typename PointT>
std::size_t
PlaneAdjustment<PointT>::addPointCloudLoader(Loader loader,
                                             const acmap::RigidMotion& pose)
{
  return this->add(std::move(loader), pose, {});
}

template <typename PointT>
void
PlaneAdjustment<PointT>::clear()
{
  Base::clear();
  settings_.action_covariances.clear();
  settings_.revisits.clear();
}

template <typename PointT>
void
PlaneAdjustment<PointT>::addRevisit(std::size_t earlier,
                                    std::size_t later,
                                    const acmap::RigidMotion& T_earlier_later,
                                    const Eigen::Matrix<double, 6, 6>& covariance)
{
  acmap::requireObservation(later, this->poses_.size());
  if (earlier >= later)
    throw acmap::BadArgument("a revisit needs the earlier view first, not " +
                             std::to_string(earlier) + " and " + std::to_string(later));
  acmap::requireActionCovariance(covariance);
  settings_.revisits.push_back(
      {earlier, later, acmap::requirePlace(T_earlier_later), covariance});
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
  if (this->poses_.empty())
    throw acmap::InitFailed("no point cloud was added");
  PlaneAdjustmentReport report;
  const acmap::AdjustedViewReader read =
      [this](std::size_t i,
             const std::function<void(const acmap::AdjustedView&)>& use) {
        const PointCloudConstPtr cloud = this->loaders_[i]();
        use(cloud ? acmap::adjustedViewOf(*cloud) : acmap::AdjustedView());
      };
  std::vector<Eigen::Isometry3d> poses;
  acmap::withThreads(this->threads_, [&] {
    poses = acmap::adjustPlanes(
        read, this->given_, settings_, acmap::Progress(this->progress_), report);
  });
  this->poses_ = std::move(poses);
  this->report_ = std::move(report);
}

} // namespace pcl

#define PCL_INSTANTIATE_PlaneAdjustment(T) \
  PCL_INSTANTIATE_RegisteringFilter(       \
      T,                                   \
      pcl::PlaneAdjustmentReport) template class ACMAP_EXPORT pcl::PlaneAdjustment<T>;
