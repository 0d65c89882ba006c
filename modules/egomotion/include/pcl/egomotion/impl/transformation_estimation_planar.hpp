#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/egomotion/transformation_estimation_planar.h>

#include <limits>

namespace pcl {
namespace acmap {

template <typename PointT>
std::vector<Eigen::Vector3d>
placesOf(const PointCloud<PointT>& cloud)
{
  requireShape<BadArgument>(cloud.width, cloud.height, cloud.size());
  std::vector<Eigen::Vector3d> places;
  places.reserve(cloud.size());
  for (const PointT& point : cloud)
    places.emplace_back(point.x, point.y, point.z);
  return places;
}

template <typename PointT>
std::vector<Eigen::Vector3d>
placesOf(const PointCloud<PointT>& cloud, const Indices& indices)
{
  requireShape<BadArgument>(cloud.width, cloud.height, cloud.size());
  std::vector<Eigen::Vector3d> places;
  places.reserve(indices.size());
  for (const index_t index : indices) {
    requireIndex<BadArgument>(index, cloud.size());
    const PointT& point = cloud[static_cast<std::size_t>(index)];
    places.emplace_back(point.x, point.y, point.z);
  }
  return places;
}

} // namespace acmap

namespace registration {

template <typename PointSource, typename PointTarget, typename Scalar>
void
TransformationEstimationPlanar<PointSource, PointTarget, Scalar>::
    setCorrespondenceWeights(const std::vector<double>& weights)
{
  for (const double weight : weights)
    acmap::requireInRange(
        "weight", weight, 0.0, std::numeric_limits<double>::max(), "(finite)");
  weights_ = weights;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void
TransformationEstimationPlanar<PointSource, PointTarget, Scalar>::
    estimateRigidTransformation(const PointCloud<PointSource>& cloud_src,
                                const PointCloud<PointTarget>& cloud_tgt,
                                Matrix4& transformation_matrix) const
{
  fit(acmap::placesOf(cloud_src), acmap::placesOf(cloud_tgt), transformation_matrix);
}

template <typename PointSource, typename PointTarget, typename Scalar>
void
TransformationEstimationPlanar<PointSource, PointTarget, Scalar>::
    estimateRigidTransformation(const PointCloud<PointSource>& cloud_src,
                                const Indices& indices_src,
                                const PointCloud<PointTarget>& cloud_tgt,
                                Matrix4& transformation_matrix) const
{
  fit(acmap::placesOf(cloud_src, indices_src),
      acmap::placesOf(cloud_tgt),
      transformation_matrix);
}

template <typename PointSource, typename PointTarget, typename Scalar>
void
TransformationEstimationPlanar<PointSource, PointTarget, Scalar>::
    estimateRigidTransformation(const PointCloud<PointSource>& cloud_src,
                                const Indices& indices_src,
                                const PointCloud<PointTarget>& cloud_tgt,
                                const Indices& indices_tgt,
                                Matrix4& transformation_matrix) const
{
  fit(acmap::placesOf(cloud_src, indices_src),
      acmap::placesOf(cloud_tgt, indices_tgt),
      transformation_matrix);
}

template <typename PointSource, typename PointTarget, typename Scalar>
void
TransformationEstimationPlanar<PointSource, PointTarget, Scalar>::
    estimateRigidTransformation(const PointCloud<PointSource>& cloud_src,
                                const PointCloud<PointTarget>& cloud_tgt,
                                const Correspondences& correspondences,
                                Matrix4& transformation_matrix) const
{
  Indices source, target;
  for (const Correspondence& match : correspondences) {
    source.push_back(match.index_query);
    target.push_back(match.index_match);
  }
  estimateRigidTransformation(
      cloud_src, source, cloud_tgt, target, transformation_matrix);
}

template <typename PointSource, typename PointTarget, typename Scalar>
void
TransformationEstimationPlanar<PointSource, PointTarget, Scalar>::fit(
    const Places& source, const Places& target, Matrix4& transformation_matrix) const
{
  const auto requireAsMany =
      [](const char* name, std::size_t count, std::size_t pairs) {
        if (count != pairs)
          acmap::refuseArgument(name,
                                static_cast<double>(count),
                                "as many as source points, " + std::to_string(pairs));
      };
  requireAsMany("number of target points", target.size(), source.size());
  if (!weights_.empty())
    requireAsMany("number of weights", weights_.size(), source.size());
  transformation_matrix = acmap::fitMotion(source, target, weights_, model_, solver_)
                              .T_target_source.matrix()
                              .template cast<Scalar>();
}

} // namespace registration
} // namespace pcl
