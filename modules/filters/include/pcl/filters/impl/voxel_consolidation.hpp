#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/impl/point_fields.h>
#include <pcl/filters/impl/consolidation_kernel.h>
#include <pcl/filters/voxel_consolidation.h>

namespace pcl {

template <typename PointT>
VoxelConsolidation<PointT>::VoxelConsolidation()
{
  filter_name_ = "VoxelConsolidation";
}

template <typename PointT>
void
VoxelConsolidation<PointT>::setInputCloud(const PointCloudConstPtr& cloud)
{
  acmap::requireGiven(cloud);
  Filter<PointT>::setInputCloud(cloud);
}

template <typename PointT>
void
VoxelConsolidation<PointT>::filter(PointCloud& output)
{
  acmap::requireInput<PointT>(input_, nullptr);
  PointCloud result;
  Filter<PointT>::filter(result);
  output = std::move(result);
}

template <typename PointT>
void
VoxelConsolidation<PointT>::applyFilter(PointCloud& output)
{
  // here, since a call by a pointer to Filter comes by no other function of this class
  acmap::requireInput<PointT>(input_, this->fake_indices_ ? nullptr : indices_.get());
  const PointT* points = input_->empty() ? nullptr : input_->points.data();
  const acmap::PointView view(points ? &points->x : nullptr,
                              sizeof(PointT),
                              indices_->size(),
                              indices_->data());
  ConsolidationReport report;
  const acmap::SensorView sensors = acmap::sensorsOf(*input_, *indices_, viewpoints_);
  const acmap::Consolidation consolidation =
      acmap::consolidatePoints(view,
                               sensors,
                               acmap::colorsOf(*input_),
                               settings(),
                               acmap::Progress(progress_),
                               report);

  PointCloud result;
  result.reserve(consolidation.representatives.size());
  for (const acmap::Representative& representative : consolidation.representatives) {
    PointT point = points[view.index(static_cast<std::size_t>(representative.witness))];
    point.getVector3fMap() = representative.point;
    acmap::setNormal(point, representative.normal, representative.curvature);
    acmap::setColor(point, representative.color);
    result.push_back(point);
  }
  result.is_dense = report.without_normal == 0;
  keepSources(consolidation.representative_of, result.size());
  output.points = std::move(result.points);
  output.width = static_cast<std::uint32_t>(output.points.size());
  output.height = 1;
  output.is_dense = result.is_dense;
  report_ = std::move(report);
}

template <typename PointT>
void
VoxelConsolidation<PointT>::keepSources(const PointLabels& representative_of,
                                        std::size_t size)
{
  SourceIndices sources;
  Indices voxel_of_point;
  if (getKeepSources()) {
    voxel_of_point.assign(input_->size(), -1);
    for (std::size_t i = 0; i < representative_of.size(); ++i)
      voxel_of_point[(*indices_)[i]] = representative_of[i];
    sources.offsets.assign(size + 1, 0);
    for (const index_t voxel : voxel_of_point)
      if (voxel >= 0)
        ++sources.offsets[voxel + 1];
    for (std::size_t i = 0; i < size; ++i)
      sources.offsets[i + 1] += sources.offsets[i];
    sources.indices.resize(sources.offsets.back());
    std::vector<std::size_t> next(sources.offsets);
    for (std::size_t i = 0; i < voxel_of_point.size(); ++i)
      if (voxel_of_point[i] >= 0)
        sources.indices[next[voxel_of_point[i]]++] = static_cast<index_t>(i);
  }
  sources_ = std::move(sources);
  voxel_of_point_ = std::move(voxel_of_point);
}

} // namespace pcl

#define PCL_INSTANTIATE_VoxelConsolidation(T) \
  template class ACMAP_EXPORT pcl::VoxelConsolidation<T>;
