#pragma once

#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/point_fields.h>
#include <pcl/mapping/impl/map_entropy_kernel.h>
#include <pcl/mapping/impl/rectification_kernel.h>
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
std::size_t
MapLevelling<PointT>::addPointCloud(const PointCloudConstPtr& cloud,
                                    const Eigen::Isometry3d& pose,
                                    const std::vector<float>& weights)
{
  if (!cloud)
    throw BadArgumentException("an observation needs a cloud");
  acmap::requireMapPose(pose);
  acmap::requirePointWeights(weights, cloud->size());
  clouds_.push_back(cloud);
  weights_.push_back(weights);
  given_.push_back(pose);
  return given_.size() - 1;
}

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
  clouds_.clear();
  weights_.clear();
  given_.clear();
  rotation_.setIdentity();
}

template <typename PointT>
void
MapLevelling<PointT>::compute()
{
  if (clouds_.empty())
    PCL_THROW_EXCEPTION(InitFailedException, "no point cloud was added");
  MapLevellingReport report;
  acmap::StepTimer timer(report);
  const acmap::Progress progress(progress_);
  progress.tell(0, "levelling");
  std::vector<acmap::ObservedSurface> observations(clouds_.size());
  acmap::withThreads(threads_, [&] {
    oneapi::tbb::parallel_for(std::size_t{0}, clouds_.size(), [&](std::size_t i) {
      observations[i] = acmap::surfaceOf(*clouds_[i], weights_[i]);
    });
  });
  for (const acmap::ObservedSurface& seen : observations) {
    report.points += seen.points;
    report.invalid_points += seen.invalid_points;
  }
  const Eigen::Quaterniond rotation =
      acmap::levelMap(observations, given_, given_up_, report);
  progress.tell(1, "levelling");
  timer.finish("level");
  rotation_ = rotation;
  report_ = std::move(report);
}

template <typename PointT>
Eigen::Isometry3d
MapLevelling<PointT>::getPose(std::size_t number) const
{
  acmap::requireObservation(number, given_.size());
  if (rotation_.isApprox(Eigen::Quaterniond::Identity(), 0)) // bitwise the given pose
    return given_[number];
  return rotation_ * given_[number];
}

} // namespace pcl

#define PCL_INSTANTIATE_MapLevelling(T) \
  template class ACMAP_EXPORT pcl::MapLevelling<T>;
