#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/impl/mesh_input.h>
#include <pcl/segmentation/impl/plane_clustering_kernel.h>
#include <pcl/segmentation/plane_conversions.h>
#include <pcl/segmentation/plane_hypothesis_clustering.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {

template <typename PointT>
void
PlaneHypothesisClustering<PointT>::setTriangles(const std::vector<Vertices>& polygons)
{
  triangles_ = acmap::trianglesOf(polygons);
}

template <typename PointT>
void
PlaneHypothesisClustering<PointT>::setClusterTolerance(double distance)
{
  acmap::requireInRange("cluster tolerance W_d", distance, 1e-9, 1e9, "m");
  member_distance_ = distance;
}

template <typename PointT>
void
PlaneHypothesisClustering<PointT>::setSmoothnessThreshold(double angle)
{
  acmap::requireInRange("smoothness threshold W_n", angle, 1e-6, M_PI / 2, "rad");
  normal_angle_ = angle;
}

template <typename PointT>
void
PlaneHypothesisClustering<PointT>::setDistanceThreshold(double distance)
{
  acmap::requireInRange("distance threshold W_t", distance, 1e-9, 1e9, "m");
  plane_distance_ = distance;
}

template <typename PointT>
double
PlaneHypothesisClustering<PointT>::getDistanceThreshold() const
{
  return plane_distance_.value_or(noise_driven_ ? 0 : acmap::paper_plane_distance);
}

template <typename PointT>
void
PlaneHypothesisClustering<PointT>::setMinArea(double area)
{
  acmap::requireInRange("minimum area", area, 0.0, 1e12, "m^2");
  min_area_ = area;
}

template <typename PointT>
void
PlaneHypothesisClustering<PointT>::requireInputs() const
{
  acmap::requireInput<PointT>(input_, this->fake_indices_ ? nullptr : indices_.get());
  acmap::requireCornersInside(triangles_, input_->size());
  const auto requireAsMany = [&](const char* what, std::size_t number) {
    if (number != input_->size())
      PCL_THROW_EXCEPTION(InitFailedException,
                          "there are " << number << " " << what << " for "
                                       << input_->size() << " points");
  };
  if (normals_)
    requireAsMany("normals", normals_->size());
  else if (!acmap::has_normal<PointT>)
    PCL_THROW_EXCEPTION(InitFailedException,
                        "no normals: set some, or give points that have them");
  if (classes_)
    requireAsMany("vertex classes", classes_->size());
}

template <typename PointT>
LargeVector<Eigen::Vector3f>
PlaneHypothesisClustering<PointT>::gatherNormals() const
{
  LargeVector<Eigen::Vector3f> normals(
      input_->size(),
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
PlaneHypothesisClustering<PointT>::setSourceCloud(
    const CloudRows& cloud, const std::vector<Eigen::Vector3f>& viewpoints)
{
  acmap::requireViewpoints(viewpoints);
  source_ = std::make_shared<const CloudRows>(cloud);
  source_points_ = cloud ? acmap::requirePoints(cloud) : acmap::PointView();
  source_sensors_ = cloud && !viewpoints.empty()
                        ? acmap::sensorsOf(cloud, viewpoints, viewpoints.front())
                        : acmap::SensorView();
  viewpoints_ = cloud ? viewpoints : std::vector<Eigen::Vector3f>();
}

template <typename PointT>
acmap::SensorView
PlaneHypothesisClustering<PointT>::pointSensors(const std::int32_t* chosen) const
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
double
PlaneHypothesisClustering<PointT>::estimateSeconds() const
{
  const auto isUsable = [](const auto& point) {
    return point.getNormalVector3fMap().allFinite();
  };
  bool has_normals = false;
  if (normals_)
    has_normals = std::any_of(normals_->begin(), normals_->end(), isUsable);
  else if constexpr (acmap::has_normal<PointT>)
    has_normals = input_ && std::any_of(input_->begin(), input_->end(), isUsable);
  if (!input_ || input_->empty() || noise_driven_ || !has_normals)
    return 0;
  return acmap::secondsOfPaperGrowth(
      acmap::PointView(&input_->front().x, sizeof(PointT), input_->size()),
      member_distance_);
}

template <typename PointT>
void
PlaneHypothesisClustering<PointT>::segment(std::vector<PlanePatch>& patches)
{
  requireInputs();
  if (!this->initCompute())
    PCL_THROW_EXCEPTION(InitFailedException, "the input cloud was refused");
  const void* const first = input_->empty() ? nullptr : &input_->front().x;
  acmap::PlaneHypotheses hypotheses;
  hypotheses.points = acmap::PointView(first, sizeof(PointT), input_->size());
  hypotheses.normals = gatherNormals();
  hypotheses.triangles = triangles_;
  if (classes_)
    for (const Label& label : *classes_)
      hypotheses.is_crease.push_back(label.label >= 2 ? 1 : 0);
  if (normals_)
    for (const Normal& normal : *normals_)
      hypotheses.curvatures.push_back(normal.curvature);
  const bool are_all = this->fake_indices_;
  std::vector<std::int32_t> chosen;
  if (!are_all) {
    chosen.assign(indices_->begin(), indices_->end());
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    acmap::keepChosen(chosen, hypotheses);
    hypotheses.points =
        acmap::PointView(first, sizeof(PointT), chosen.size(), chosen.data());
  }
  hypotheses.sensors = pointSensors(are_all ? nullptr : chosen.data());
  this->deinitCompute();

  acmap::PlaneClusteringSettings settings;
  settings.noise_driven = noise_driven_;
  settings.member_distance = member_distance_;
  settings.normal_angle = normal_angle_;
  settings.plane_distance = getDistanceThreshold();
  settings.min_support = min_support_;
  settings.min_area = min_area_;
  settings.regular = regularize_;
  settings.threads = threads_;
  PlaneClusteringReport report;
  acmap::PlaneClusters clusters =
      acmap::clusterPlanes(hypotheses,
                           {source_points_, source_sensors_},
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
PlaneHypothesisClustering<PointT>::extract(std::vector<PointIndices>& clusters)
{
  std::vector<PlanePatch> patches;
  segment(patches);
  clusters = acmap::clustersOf(labels_, patches.size(), input_->header);
}

} // namespace pcl

#define PCL_INSTANTIATE_PlaneHypothesisClustering(T) \
  template class ACMAP_EXPORT pcl::PlaneHypothesisClustering<T>;
