#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/mapping/impl/posed_clouds.h>
#include <pcl/mapping/map_levelling.h>

namespace pcl {
namespace acmap {

template <typename PointT>
ObservedSurface
surfaceOf(const PointCloud<PointT>& cloud, const std::vector<float>& weights)
{
  return observedSurface(pointsOf(cloud), normalsOf(cloud), weights);
}

} // namespace acmap

template <typename PointT>
void
MapLevelling<PointT>::setUpDirection(const Eigen::Vector3d& up)
{
  given_up_ = acmap::requiredDirection(up);
}

template <typename PointT>
void
MapLevelling<PointT>::clear()
{
  Base::clear();
  rotation_.setIdentity();
}

template <typename PointT>
void
MapLevelling<PointT>::compute()
{
  if (this->poses_.empty())
    throw acmap::InitFailed("no point cloud was added");
  MapLevellingReport report;
  acmap::StepTimer timer(report);
  const acmap::Progress progress(this->progress_);
  progress.tell(0, "levelling");
  std::vector<acmap::ObservedSurface> observations(this->poses_.size());
  acmap::withThreads(this->threads_, [&] {
    oneapi::tbb::parallel_for(std::size_t{0}, this->poses_.size(), [&](std::size_t i) {
      observations[i] = acmap::surfaceOf(*this->loaders_[i](), this->weights_[i]);
    });
  });
  for (const acmap::ObservedSurface& seen : observations) {
    report.points += seen.points;
    report.invalid_points += seen.invalid_points;
  }
  const Eigen::Quaterniond rotation =
      acmap::levelMap(observations, this->given_, given_up_, report);
  progress.tell(1, "levelling");
  timer.finish("level");
  rotation_ = rotation;
  this->poses_ = this->given_;
  if (!rotation.isApprox(Eigen::Quaterniond::Identity(), 0)) // else bitwise the same
    for (Eigen::Isometry3d& pose : this->poses_)
      pose = rotation * pose;
  this->report_ = std::move(report);
}

} // namespace pcl

#define PCL_INSTANTIATE_MapLevelling(T) \
  PCL_INSTANTIATE_PosedClouds(          \
      T,                                \
      Eigen::Isometry3d,                \
      pcl::MapLevellingReport) template class ACMAP_EXPORT pcl::MapLevelling<T>;
