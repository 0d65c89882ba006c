#pragma once

#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/point_fields.h>
#include <pcl/egomotion/impl/camera_image.h>
#include <pcl/egomotion/visual_egomotion.h>

namespace pcl {
namespace acmap {

template <typename PointT>
CameraView
cameraViewOf(const PointCloud<PointT>& cloud)
{
  CameraView view;
  view.image = brightnessOf(cloud);
  view.points.reserve(cloud.size());
  for (const PointT& point : cloud)
    view.points.push_back(point.getVector3fMap());
  if constexpr (traits::has_field<PointT, fields::sigma>::value)
    for (const PointT& point : cloud)
      view.sigmas.push_back(point.sigma);
  return view;
}

template <typename PointT>
Correspondences
correspondencesOf(const PointCloud<PointT>& source,
                  const PointCloud<PointT>& target,
                  const PixelPairs& pixels)
{
  Correspondences correspondences;
  for (const auto& [query, match] : pixels)
    correspondences.emplace_back(
        query,
        match,
        (source[query].getVector3fMap() - target[match].getVector3fMap())
            .squaredNorm());
  return correspondences;
}

} // namespace acmap

template <typename PointT>
void
VisualEgomotion<PointT>::setMaximumTranslation(double metres)
{
  acmap::requireInRange("maximum translation", metres, 0.001, 1e6, "m");
  settings_.max_translation = metres;
}

template <typename PointT>
void
VisualEgomotion<PointT>::setMaximumRotation(double radians)
{
  acmap::requireInRange("maximum rotation", radians, 0, 3.1415926536, "rad");
  settings_.max_rotation = radians;
}

template <typename PointT>
void
VisualEgomotion<PointT>::setMaximumKeypoints(std::size_t keypoints)
{
  acmap::requireInRange(
      "maximum keypoints", static_cast<double>(keypoints), 10, 100000, "keypoints");
  settings_.keypoints.maximum = keypoints;
  kept_.clear();
}

template <typename PointT>
void
VisualEgomotion<PointT>::setMaximumShifts(int rings, int sectors)
{
  const acmap::LogPolarSettings& patches = settings_.patches;
  acmap::requireInRange("ring shifts", rings, 0, patches.rings - 2, "rings");
  acmap::requireInRange("sector shifts", sectors, 0, patches.sectors / 2, "sectors");
  settings_.shifts = acmap::PatchShifts{rings, sectors};
}

template <typename PointT>
std::shared_ptr<const acmap::EgomotionView>
VisualEgomotion<PointT>::prepared(const PointCloudConstPtr& cloud)
{
  for (const Prepared& kept : kept_)
    if (kept.cloud == cloud)
      return kept.view;
  return acmap::prepareView(acmap::cameraViewOf(*cloud), acmap::inMode(settings_));
}

template <typename PointT>
std::optional<EgomotionEstimate>
VisualEgomotion<PointT>::compute()
{
  acmap::requireImage<PointT>(source_, nullptr);
  acmap::requireImage<PointT>(target_, nullptr);
  EgomotionReport report;
  acmap::StepTimer timer(report);
  const acmap::Progress progress(progress_);
  return acmap::withThreads(settings_.threads, [&] {
    const Prepared target{target_, prepared(target_)};
    progress.tell(0.25, "look");
    const Prepared source{source_,
                          source_ == target_ ? target.view : prepared(source_)};
    progress.tell(0.5, "look");
    timer.finish("look");
    const acmap::EgomotionSolution solution = acmap::estimateEgomotion(
        *source.view, *target.view, acmap::inMode(settings_), progress, report);
    matches_ = acmap::correspondencesOf(*source_, *target_, solution.matches);
    inliers_ = acmap::correspondencesOf(*source_, *target_, solution.inliers);
    kept_ = {target, source};
    report_ = std::move(report);
    return solution.estimate;
  });
}

} // namespace pcl

#define PCL_INSTANTIATE_VisualEgomotion(T) \
  template class ACMAP_EXPORT pcl::VisualEgomotion<T>;
