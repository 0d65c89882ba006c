#pragma once

#include <pcl/common/io.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/egomotion/gradient_maximum_keypoint.h>
#include <pcl/egomotion/impl/camera_image.h>

#include <sstream>
#include <utility>

namespace pcl {
namespace acmap {

/** \brief Adds a remark if a run gives no keypoint. */
inline void
remark(const KeypointCounts& counts, float min_gradient, GradientMaximumReport& report)
{
  if (report.keypoints > 0)
    return;
  std::ostringstream text;
  if (counts.maxima > 0)
    text << "none of the " << counts.maxima << " maxima of the gradient has a place";
  else
    text << "no maximum of the gradient reaches " << min_gradient
         << " grey levels a pixel";
  report.remarks.push_back(text.str());
}

} // namespace acmap

template <typename PointT>
GradientMaximumKeypoint<PointT>::GradientMaximumKeypoint()
{
  this->name_ = "GradientMaximumKeypoint";
}

template <typename PointT>
void
GradientMaximumKeypoint<PointT>::setMinimumGradient(float gradient)
{
  acmap::requireInRange(
      "minimum gradient", gradient, 0.0, 1000.0, "grey levels a pixel");
  settings_.min_gradient = gradient;
}

template <typename PointT>
void
GradientMaximumKeypoint<PointT>::setMaximumKeypoints(std::size_t keypoints)
{
  acmap::requireInRange(
      "maximum keypoints", static_cast<double>(keypoints), 1.0, 1e6, "keypoints");
  settings_.maximum = keypoints;
}

template <typename PointT>
void
GradientMaximumKeypoint<PointT>::compute(PointCloudOut& output)
{
  PointCloudOut result;
  Keypoint<PointT, PointT>::compute(result);
  output = std::move(result);
}

template <typename PointT>
bool
GradientMaximumKeypoint<PointT>::initCompute()
{
  acmap::requireImage<PointT>(input_, this->fake_indices_ ? nullptr : indices_.get());
  return PCLBase<PointT>::initCompute();
}

template <typename PointT>
void
GradientMaximumKeypoint<PointT>::detectKeypoints(PointCloudOut& output)
{
  GradientMaximumReport report;
  acmap::StepTimer timer(report);
  acmap::KeypointCounts counts;
  PointIndicesPtr found(new PointIndices);
  found->header = input_->header;
  found->indices = acmap::gradientMaxima(acmap::brightnessOf(*input_),
                                         acmap::placesIn(*input_, *indices_),
                                         settings_,
                                         counts);
  copyPointCloud(*input_, found->indices, output);
  output.is_dense = true;
  timer.finish("maxima of the gradient");
  report.keypoints = found->indices.size();
  report.maxima = counts.maxima;
  report.without_place = counts.without_place;
  report.left_out = counts.left_out;
  acmap::remark(counts, settings_.min_gradient, report);
  keypoints_indices_ = std::move(found);
  report_ = std::move(report);
}

} // namespace pcl

#define PCL_INSTANTIATE_GradientMaximumKeypoint(T) \
  template class ACMAP_EXPORT pcl::GradientMaximumKeypoint<T>;
