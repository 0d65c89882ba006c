#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/impl/mesh_input.h>
#include <pcl/segmentation/cylinder_hypothesis_clustering.h>
#include <pcl/segmentation/impl/cylinder_clustering_kernel.h>
#include <pcl/segmentation/plane_conversions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {

template <typename PointT>
void
CylinderHypothesisClustering<PointT>::setTriangles(
    const std::vector<Vertices>& polygons)
{
  triangles_ = acmap::trianglesOf(polygons);
}

template <typename PointT>
void
CylinderHypothesisClustering<PointT>::setRadiusLimits(double min_radius,
                                                      double max_radius)
{
  acmap::requireInRange("minimum radius", min_radius, 0.0, 1e9, "m");
  acmap::requireInRange("maximum radius", max_radius, min_radius, 1e9, "m");
  min_radius_ = min_radius;
  max_radius_ = max_radius;
}

template <typename PointT>
void
CylinderHypothesisClustering<PointT>::setNoise(double sigma)
{
  acmap::requireInRange("noise", sigma, 0.0, 1e9, "m");
  sigma_ = sigma;
}

template <typename PointT>
void
CylinderHypothesisClustering<PointT>::setSourceScale(const NoiseScale& scale)
{
  acmap::requireInRange("noise of the source", scale.sigma, 0.0, 1e9, "m");
  acmap::requireInRange("spacing of the source", scale.spacing, 0.0, 1e9, "m");
  source_scale_ = scale;
}

template <typename PointT>
void
CylinderHypothesisClustering<PointT>::setSourceCloud(
    const CloudRows& cloud, const std::vector<Eigen::Vector3f>& viewpoints)
{
  acmap::requireViewpoints(viewpoints);
  source_scale_.reset();
  source_ = std::make_shared<const CloudRows>(cloud);
  source_points_ = cloud ? acmap::requirePoints(cloud) : acmap::PointView();
  source_sensors_ = cloud && !viewpoints.empty()
                        ? acmap::sensorsOf(cloud, viewpoints, viewpoints.front())
                        : acmap::SensorView();
  viewpoints_ = cloud ? viewpoints : std::vector<Eigen::Vector3f>();
}

template <typename PointT>
acmap::SensorView
CylinderHypothesisClustering<PointT>::pointSensors(const std::int32_t* chosen) const
{
  if (viewpoints_.size() == 1)
    return acmap::SensorView(viewpoints_.front());
  if constexpr (acmap::has_view<PointT>)
    if (!input_->empty() && !viewpoints_.empty())
      return acmap::SensorView(
          &input_->front().view, sizeof(PointT), viewpoints_, chosen);
  return {};
}

template <typename PointT>
void
CylinderHypothesisClustering<PointT>::requireInputs() const
{
  acmap::requireInput<PointT>(input_, this->fake_indices_ ? nullptr : indices_.get());
  acmap::requireCornersInside(triangles_, input_->size());
  const auto requireAsMany =
      [](const char* what, std::size_t number, std::size_t size) {
        if (number != size)
          PCL_THROW_EXCEPTION(InitFailedException,
                              "there are " << number << " " << what << " for " << size
                                           << " points");
      };
  if (normals_)
    requireAsMany("normals", normals_->size(), input_->size());
  if (!planes_.empty() || !plane_labels_.empty())
    requireAsMany("labels of planes", plane_labels_.size(), input_->size());
  if (!plane_source_labels_.empty())
    requireAsMany("labels of planes of the source",
                  plane_source_labels_.size(),
                  source_points_.size());
  const auto size = static_cast<std::int32_t>(planes_.size());
  const auto requirePlane = [size](std::int32_t label) {
    if (label < -1 || label >= size)
      PCL_THROW_EXCEPTION(InitFailedException,
                          "there is no plane " << label << ", only " << size);
  };
  std::for_each(plane_labels_.begin(), plane_labels_.end(), requirePlane);
  std::for_each(plane_source_labels_.begin(), plane_source_labels_.end(), requirePlane);
}

template <typename PointT>
LargeVector<Eigen::Vector3f>
CylinderHypothesisClustering<PointT>::gatherNormals() const
{
  LargeVector<Eigen::Vector3f> normals;
  if (!normals_ && !acmap::has_normal<PointT>)
    return normals;
  normals.resize(input_->size(),
                 Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  for (const index_t index : *indices_) {
    Eigen::Vector3f& normal = normals[static_cast<std::size_t>(index)];
    if (normals_)
      normal = (*normals_)[index].getNormalVector3fMap();
    else if constexpr (acmap::has_normal<PointT>)
      normal = (*input_)[index].getNormalVector3fMap();
    if (!acmap::isUnit(normal))
      normal /= normal.norm(); // a normal of length zero becomes NaN
  }
  return normals;
}

template <typename PointT>
void
CylinderHypothesisClustering<PointT>::segment(std::vector<CylinderPatch>& patches)
{
  requireInputs();
  if (!this->initCompute())
    PCL_THROW_EXCEPTION(InitFailedException, "the input cloud was refused");
  const void* const first = input_->empty() ? nullptr : &input_->front().x;
  acmap::PlaneHypotheses hypotheses;
  hypotheses.points = acmap::PointView(first, sizeof(PointT), input_->size());
  hypotheses.normals = gatherNormals();
  hypotheses.triangles = triangles_;
  acmap::GivenPlanes planes{planes_, plane_labels_, plane_source_labels_};
  const bool are_all = this->fake_indices_;
  std::vector<std::int32_t> chosen;
  if (!are_all) {
    chosen.assign(indices_->begin(), indices_->end());
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    hypotheses.normals.resize(input_->size());
    acmap::keepChosen(chosen, hypotheses);
    if (!normals_ && !acmap::has_normal<PointT>)
      hypotheses.normals.clear();
    hypotheses.points =
        acmap::PointView(first, sizeof(PointT), chosen.size(), chosen.data());
    planes.labels.clear();
    if (!plane_labels_.empty())
      for (const std::int32_t index : chosen)
        planes.labels.push_back(plane_labels_[static_cast<std::size_t>(index)]);
  }
  hypotheses.sensors = pointSensors(are_all ? nullptr : chosen.data());
  this->deinitCompute();

  acmap::CylinderClusteringSettings settings;
  settings.min_radius = min_radius_;
  settings.max_radius = max_radius_;
  settings.sigma = sigma_;
  settings.source_scale = source_scale_;
  settings.threads = threads_;
  CylinderClusteringReport report;
  acmap::CylinderClusters clusters =
      acmap::clusterCylinders(hypotheses,
                              {source_points_, source_sensors_},
                              planes,
                              settings,
                              acmap::Progress(progress_),
                              report);
  patches = std::move(clusters.patches);
  if (are_all)
    labels_ = std::move(clusters.labels);
  else
    labels_.assign(input_->size(), -1);
  for (std::size_t i = 0; i < chosen.size(); ++i)
    labels_[static_cast<std::size_t>(chosen[i])] = clusters.labels[i];
  source_labels_ = std::move(clusters.source_labels);
  report_ = std::move(report);
}

template <typename PointT>
void
CylinderHypothesisClustering<PointT>::extract(std::vector<PointIndices>& clusters)
{
  std::vector<CylinderPatch> patches;
  segment(patches);
  clusters = acmap::clustersOf(labels_, patches.size(), input_->header);
}

} // namespace pcl

#define PCL_INSTANTIATE_CylinderHypothesisClustering(T) \
  template class ACMAP_EXPORT pcl::CylinderHypothesisClustering<T>;
