#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/impl/mesh_input.h>
#include <pcl/core/impl/point_fields.h>
#include <pcl/features/impl/voting_kernel.h>
#include <pcl/features/normal_vector_voting.h>

namespace pcl {

template <typename PointInT>
NormalVectorVoting<PointInT>::NormalVectorVoting()
{
  feature_name_ = "NormalVectorVoting";
}

template <typename PointInT>
void
NormalVectorVoting<PointInT>::compute(PointCloudOut& output)
{
  PointCloudOut result;
  Feature<PointInT, Normal>::compute(result);
  output = std::move(result);
}

template <typename PointInT>
bool
NormalVectorVoting<PointInT>::initCompute()
{
  acmap::requireInput<PointInT>(input_, this->fake_indices_ ? nullptr : indices_.get());
  acmap::requireCornersInside(triangles_, input_->size());
  return PCLBase<PointInT>::initCompute();
}

template <typename PointInT>
void
NormalVectorVoting<PointInT>::computeFeature(PointCloudOut& output)
{
  acmap::VotingSettings settings = this->settings();
  settings.radius = search_radius_;
  settings.compute_curvatures = compute_curvatures_;
  VotingReport report;
  const acmap::VotedNormals votes =
      acmap::voteNormals(acmap::pointsOf(*input_),
                         triangles_,
                         acmap::namedSensorsOf(*input_, viewpoints_),
                         settings,
                         acmap::Progress(progress_),
                         report);

  if (indices_->empty() && !input_->empty())
    report.remarks.push_back("no normals: the indices that were set are none");
  PointCloud<Label> classes;
  PointCloud<PrincipalCurvatures> curvatures;
  output.is_dense = true;
  for (std::size_t i = 0; i < indices_->size(); ++i) {
    const auto vertex = static_cast<std::size_t>((*indices_)[i]);
    const acmap::VotedNormal& voted = votes.normals[vertex];
    output[i].getNormalVector3fMap() = voted.normal;
    output[i].curvature = 1 - voted.saliency;
    if (voted.vertex_class == VertexClass::Unknown)
      output.is_dense = false;
    Label label;
    label.label = static_cast<std::uint32_t>(voted.vertex_class);
    classes.push_back(label);
    if (compute_curvatures_) {
      const acmap::VotedCurvature& voted_curvature = votes.curvatures[vertex];
      PrincipalCurvatures curvature;
      for (int axis = 0; axis < 3; ++axis)
        curvature.principal_curvature[axis] = voted_curvature.direction[axis];
      curvature.pc1 = voted_curvature.first;
      curvature.pc2 = voted_curvature.second;
      curvatures.push_back(curvature);
    }
  }
  classes_ = std::move(classes);
  curvatures_ = std::move(curvatures);
  report_ = std::move(report);
}

} // namespace pcl

#define PCL_INSTANTIATE_NormalVectorVoting(T) \
  template class ACMAP_EXPORT pcl::NormalVectorVoting<T>;
