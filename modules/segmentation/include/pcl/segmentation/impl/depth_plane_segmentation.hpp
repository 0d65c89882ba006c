#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/depth_view.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/segmentation/depth_plane_segmentation.h>
#include <pcl/segmentation/impl/depth_plane_kernel.h>
#include <pcl/segmentation/plane_conversions.h>

#include <algorithm>
#include <limits>

namespace pcl {

template <typename PointT>
void
DepthPlaneSegmentation<PointT>::setMinArea(double area)
{
  acmap::requireInRange("minimum area", area, 0.0, 1e12, "m^2 (0 = automatic)");
  settings_.min_area = area;
}

template <typename PointT>
void
DepthPlaneSegmentation<PointT>::segment(std::vector<PlanePatch>& patches)
{
  const Indices* const wanted = this->fake_indices_ ? nullptr : indices_.get();
  acmap::requireInput<PointT>(input_, wanted);
  std::vector<Eigen::Vector3f> chosen;
  if (wanted) {
    chosen.assign(input_->size(),
                  Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
    for (const index_t index : *wanted)
      chosen[static_cast<std::size_t>(index)] = (*input_)[index].getVector3fMap();
  }
  const acmap::PointView points =
      chosen.empty() ? acmap::PointView(input_->empty() ? nullptr : &input_->front().x,
                                        sizeof(PointT),
                                        input_->size())
                     : acmap::PointView(chosen.data(), sizeof chosen[0], chosen.size());
  const std::optional<acmap::PictureView> picture = acmap::PictureView::find(
      points, input_->isOrganized() ? input_->width : points.size());
  if (!picture)
    throw acmap::Unorganized(
        "the cloud is not organized, and its points are not those of "
        "one picture in its sensor's frame");
  DepthPlaneReport report;
  acmap::PlaneClusters clusters;
  if (const auto seen = acmap::measureDepthView(picture->points(), picture->width()))
    clusters = acmap::segmentDepthPlanes(
        seen->view, seen->noise, settings_, acmap::Progress(progress_), report);
  else {
    clusters.labels.assign(picture->points().size(), -1);
    report.points = report.invalid_points = input_->size();
    report.remarks.push_back(std::string("no planes: ") + acmap::no_depth_view);
  }
  const std::optional<acmap::PictureOrder>& order = picture->order();
  patches = std::move(clusters.patches);
  labels_ = order ? order->labelsOfPoints(clusters.labels) : std::move(clusters.labels);
  if (order) {
    report.points = input_->size();
    report.invalid_points = static_cast<std::size_t>(std::count(
        order->pixels.begin(), order->pixels.end(), acmap::PictureOrder::nowhere));
  }
  report_ = std::move(report);
}

template <typename PointT>
void
DepthPlaneSegmentation<PointT>::extract(std::vector<PointIndices>& clusters)
{
  std::vector<PlanePatch> patches;
  segment(patches);
  clusters = toPointIndices(labels_, patches.size(), input_->header);
}

} // namespace pcl

#define PCL_INSTANTIATE_DepthPlaneSegmentation(T) \
  template class ACMAP_EXPORT pcl::DepthPlaneSegmentation<T>;
