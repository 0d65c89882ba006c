#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/segmentation/cylinder_hypothesis_clustering.h>

#include <algorithm>
#include <utility>

namespace pcl {

void
CylinderClusteringParameters::setRadiusLimits(double min_radius, double max_radius)
{
  acmap::requireInRange("minimum radius", min_radius, 0.0, 1e9, "m");
  acmap::requireInRange("maximum radius", max_radius, min_radius, 1e9, "m");
  settings_.min_radius = min_radius;
  settings_.max_radius = max_radius;
}

void
CylinderClusteringParameters::setNoise(double sigma)
{
  acmap::requireInRange("noise", sigma, 0.0, 1e9, "m");
  settings_.sigma = sigma;
}

void
CylinderClusteringParameters::setSourceScale(const NoiseScale& scale)
{
  acmap::requireInRange("noise of the source", scale.sigma, 0.0, 1e9, "m");
  acmap::requireInRange("spacing of the source", scale.spacing, 0.0, 1e9, "m");
  settings_.source_scale = scale;
}

acmap::CylinderClusteringSettings
CylinderClusteringParameters::settings() const
{
  acmap::CylinderClusteringSettings settings = settings_;
  settings.threads = threads_;
  return settings;
}

void
CylinderClusteringParameters::requirePlanes(std::size_t points) const
{
  if (!planes_.empty() || !plane_labels_.empty())
    requireAsMany("labels of planes", plane_labels_.size(), points);
  if (!plane_source_labels_.empty())
    requireAsMany("labels of planes of the source",
                  plane_source_labels_.size(),
                  source_points_.size());
  const auto size = static_cast<std::int32_t>(planes_.size());
  const auto requirePlane = [size](std::int32_t label) {
    if (label < -1 || label >= size)
      throw acmap::InitFailed("there is no plane ", label, ", only ", size);
  };
  std::for_each(plane_labels_.begin(), plane_labels_.end(), requirePlane);
  std::for_each(plane_source_labels_.begin(), plane_source_labels_.end(), requirePlane);
}

std::vector<CylinderPatch>
CylinderClusteringParameters::cluster(acmap::PlaneHypotheses hypotheses,
                                      const std::vector<std::int32_t>* chosen,
                                      std::size_t points)
{
  hypotheses.triangles = triangles_;
  PointLabels labels_of_chosen;
  if (chosen) {
    acmap::keepChosen(*chosen, points, hypotheses);
    if (!plane_labels_.empty())
      for (const std::int32_t index : *chosen)
        labels_of_chosen.push_back(plane_labels_[static_cast<std::size_t>(index)]);
  }
  CylinderClusteringReport report;
  acmap::CylinderClusters clusters = acmap::clusterCylinders(
      hypotheses,
      {source_points_, source_sensors_},
      {planes_, chosen ? labels_of_chosen : plane_labels_, plane_source_labels_},
      settings(),
      acmap::Progress(progress_),
      report);
  keepLabels(std::move(clusters.labels), chosen, points);
  source_labels_ = std::move(clusters.source_labels);
  report_ = std::move(report);
  return std::move(clusters.patches);
}

void
CylinderHypothesisClustering<PCLPointCloud2>::segment(
    std::vector<CylinderPatch>& patches)
{
  acmap::PlaneHypotheses hypotheses = hypothesesOf(rows_, normals_);
  const std::size_t points = hypotheses.points.size();
  requirePlanes(points);
  patches = cluster(std::move(hypotheses), nullptr, points);
}

} // namespace pcl
