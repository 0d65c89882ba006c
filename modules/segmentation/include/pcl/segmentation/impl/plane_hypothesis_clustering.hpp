#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/impl/mesh_input.h>
#include <pcl/core/impl/point_fields.h>
#include <pcl/segmentation/plane_conversions.h>
#include <pcl/segmentation/plane_hypothesis_clustering.h>

#include <utility>

namespace pcl {

template <typename PointT>
void
PlaneHypothesisClustering<PointT>::requireInputs() const
{
  acmap::requireInput<PointT>(input_, this->fake_indices_ ? nullptr : indices_.get());
  acmap::requireCornersInside(triangles_, input_->size());
  if (normals_)
    requireAsMany("normals", normals_->size(), input_->size());
  else if (!acmap::has_normal<PointT>)
    throw acmap::InitFailed("no normals: set some, or give points that have them");
  if (classes_)
    requireAsMany("vertex classes", classes_->size(), input_->size());
}

template <typename PointT>
acmap::PointView
PlaneHypothesisClustering<PointT>::normals() const
{
  return normals_ ? acmap::normalsOf(*normals_) : acmap::normalsOf(*input_);
}

template <typename PointT>
double
PlaneHypothesisClustering<PointT>::estimateSeconds() const
{
  return input_ ? secondsOf(acmap::pointsOf(*input_), normals()) : 0;
}

template <typename PointT>
void
PlaneHypothesisClustering<PointT>::segment(std::vector<PlanePatch>& patches)
{
  requireInputs();
  if (!this->initCompute())
    throw acmap::InitFailed("the input cloud was refused");
  const bool are_all = this->fake_indices_;
  const std::vector<std::int32_t> chosen =
      are_all ? std::vector<std::int32_t>() : acmap::chosenOf(*indices_);
  acmap::PlaneHypotheses hypotheses;
  hypotheses.points = acmap::pointsOf(*input_, are_all ? nullptr : &chosen);
  hypotheses.normals = acmap::unitNormals(normals());
  if (classes_)
    for (const Label& label : *classes_)
      hypotheses.is_crease.push_back(acmap::isCrease(label.label) ? 1 : 0);
  if (normals_)
    for (const Normal& normal : *normals_)
      hypotheses.curvatures.push_back(normal.curvature);
  hypotheses.sensors = pointSensors(*input_, are_all ? nullptr : chosen.data());
  this->deinitCompute();
  patches = cluster(std::move(hypotheses), are_all ? nullptr : &chosen, input_->size());
}

template <typename PointT>
void
PlaneHypothesisClustering<PointT>::extract(std::vector<PointIndices>& clusters)
{
  std::vector<PlanePatch> patches;
  segment(patches);
  clusters = toPointIndices(getLabels(), patches.size(), input_->header);
}

} // namespace pcl

#define PCL_INSTANTIATE_PlaneHypothesisClustering(T) \
  template class ACMAP_EXPORT pcl::PlaneHypothesisClustering<T>;
