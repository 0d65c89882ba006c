#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/impl/point_fields.h>
#include <pcl/filters/depth_refinement.h>
#include <pcl/filters/impl/depth_refinement_kernel.h>

#include <limits>

namespace pcl {

template <typename PointT>
DepthRefinement<PointT>::DepthRefinement()
{
  filter_name_ = "DepthRefinement";
}

template <typename PointT>
void
DepthRefinement<PointT>::setInputCloud(const PointCloudConstPtr& cloud)
{
  acmap::requireGiven(cloud);
  Filter<PointT>::setInputCloud(cloud);
}

template <typename PointT>
void
DepthRefinement<PointT>::setPlanes(const std::vector<PlanePatch>& patches,
                                   const PointLabels& labels)
{
  planes_ = acmap::depthPlanesOf(patches, labels);
}

template <typename PointT>
void
DepthRefinement<PointT>::filter(PointCloud& output)
{
  acmap::requireInput<PointT>(input_, nullptr);
  PointCloud result;
  Filter<PointT>::filter(result);
  output = std::move(result);
}

template <typename PointT>
void
DepthRefinement<PointT>::applyFilter(PointCloud& output)
{
  // here, since a call by a pointer to Filter comes by no other function of this class
  acmap::requireInput<PointT>(input_, this->fake_indices_ ? nullptr : indices_.get());
  if (!input_->empty() && !input_->isOrganized())
    acmap::refuseUnorganized();
  if (!planes_.labels.empty() && planes_.labels.size() != input_->size())
    throw acmap::InitFailed("the planes have ",
                            planes_.labels.size(),
                            " labels, the cloud has ",
                            input_->size(),
                            " points");
  PointCloud result = *input_;
  if (!this->fake_indices_) {
    std::vector<std::uint8_t> is_chosen(input_->size(), 0);
    for (const index_t index : *indices_)
      is_chosen[static_cast<std::size_t>(index)] = 1;
    for (std::size_t i = 0; i < result.size(); ++i)
      if (!is_chosen[i])
        result[i].getVector3fMap().setConstant(std::numeric_limits<float>::quiet_NaN());
  }
  const acmap::PointView points = acmap::pointsOf(result);
  DepthRefinementReport report;
  report.points = report.invalid_points = result.size();
  if (const auto seen = acmap::measureDepthView(points, result.width)) {
    const acmap::RefinedDepth refined =
        acmap::refineDepth(seen->view,
                           seen->noise,
                           planes_.labels.empty() ? nullptr : &planes_,
                           threads_,
                           acmap::Progress(progress_),
                           report);
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i].getVector3fMap() = refined.points[i];
      acmap::setNormal(result[i], refined.normals[i], 0);
    }
  }
  else
    report.remarks.push_back(std::string("nothing was refined: ") +
                             acmap::no_depth_view);
  result.is_dense = false;
  output = std::move(result);
  report_ = std::move(report);
}

} // namespace pcl

#define PCL_INSTANTIATE_DepthRefinement(T) \
  template class ACMAP_EXPORT pcl::DepthRefinement<T>;
