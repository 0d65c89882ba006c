#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/egomotion/impl/visual_egomotion.hpp>
#include <pcl/egomotion/revisit_detection.h>

namespace pcl {

template <typename PointT>
std::size_t
RevisitDetection<PointT>::addPointCloud(const PointCloudConstPtr& cloud)
{
  acmap::requireImage<PointT>(cloud, nullptr);
  return addPointCloudLoader([cloud] { return cloud; });
}

template <typename PointT>
void
RevisitDetection<PointT>::setMinimumSeparation(std::size_t views)
{
  acmap::requireInRange(
      "minimum separation", static_cast<double>(views), 1, 1e6, "views");
  settings_.min_separation = views;
}

template <typename PointT>
void
RevisitDetection<PointT>::compute()
{
  if (loaders_.empty())
    throw acmap::InitFailed("no point cloud was added");
  RevisitReport report;
  std::vector<Revisit> revisits;
  const acmap::CameraViewReader read = [this](std::size_t i) {
    const PointCloudConstPtr cloud = loaders_[i]();
    acmap::requireImage<PointT>(cloud, nullptr);
    return acmap::cameraViewOf(*cloud);
  };
  acmap::withThreads(threads_, [&] {
    revisits = acmap::detectRevisits(
        read, loaders_.size(), settings_, acmap::Progress(progress_), report);
  });
  revisits_ = std::move(revisits);
  report_ = std::move(report);
}

} // namespace pcl

#define PCL_INSTANTIATE_RevisitDetection(T) \
  template class ACMAP_EXPORT pcl::RevisitDetection<T>;
