#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/impl/mesh_input.h>
#include <pcl/core/impl/point_fields.h>
#include <pcl/segmentation/cylinder_hypothesis_clustering.h>
#include <pcl/segmentation/plane_conversions.h>

#include <utility>

namespace pcl {

template <typename PointT>
void
CylinderHypothesisClustering<PointT>::segment(std::vector<CylinderPatch>& patches)
{
  acmap::requireInput<PointT>(input_, this->fake_indices_ ? nullptr : indices_.get());
  acmap::requireCornersInside(triangles_, input_->size());
  if (normals_)
    requireAsMany("normals", normals_->size(), input_->size());
  requirePlanes(input_->size());
  if (!this->initCompute())
    throw acmap::InitFailed("the input cloud was refused");
  const bool are_all = this->fake_indices_;
  const std::vector<std::int32_t> chosen =
      are_all ? std::vector<std::int32_t>() : acmap::chosenOf(*indices_);
  acmap::PlaneHypotheses hypotheses;
  hypotheses.points = acmap::pointsOf(*input_, are_all ? nullptr : &chosen);
  hypotheses.normals = acmap::unitNormals(normals_ ? acmap::normalsOf(*normals_)
                                                   : acmap::normalsOf(*input_));
  hypotheses.sensors = pointSensors(*input_, are_all ? nullptr : chosen.data());
  this->deinitCompute();
  patches = cluster(std::move(hypotheses), are_all ? nullptr : &chosen, input_->size());
}

template <typename PointT>
void
CylinderHypothesisClustering<PointT>::extract(std::vector<PointIndices>& clusters)
{
  std::vector<CylinderPatch> patches;
  segment(patches);
  clusters = toPointIndices(getLabels(), patches.size(), input_->header);
}

} // namespace pcl

#define PCL_INSTANTIATE_CylinderHypothesisClustering(T) \
  template class ACMAP_EXPORT pcl::CylinderHypothesisClustering<T>;
