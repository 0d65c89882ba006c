#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/segmentation/plane_hypothesis_clustering.h>

#include <cmath>
#include <cstring>
#include <utility>

namespace pcl {

void
PlaneClusteringParameters::setClusterTolerance(double distance)
{
  acmap::requireInRange("cluster tolerance W_d", distance, 1e-9, 1e9, "m");
  member_distance_ = distance;
}

void
PlaneClusteringParameters::setSmoothnessThreshold(double angle)
{
  acmap::requireInRange("smoothness threshold W_n", angle, 1e-6, M_PI / 2, "rad");
  normal_angle_ = angle;
}

void
PlaneClusteringParameters::setDistanceThreshold(double distance)
{
  acmap::requireInRange("distance threshold W_t", distance, 1e-9, 1e9, "m");
  plane_distance_ = distance;
}

double
PlaneClusteringParameters::getDistanceThreshold() const
{
  return plane_distance_.value_or(noise_driven_ ? 0 : acmap::paper_plane_distance);
}

void
PlaneClusteringParameters::setMinArea(double area)
{
  acmap::requireInRange("minimum area", area, 0.0, 1e12, "m^2");
  min_area_ = area;
}

std::vector<PlanePatch>
PlaneClusteringParameters::cluster(acmap::PlaneHypotheses hypotheses,
                                   const std::vector<std::int32_t>* chosen,
                                   std::size_t points)
{
  hypotheses.triangles = triangles_;
  if (chosen)
    acmap::keepChosen(*chosen, points, hypotheses);
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
  keepLabels(std::move(clusters.labels), chosen, points);
  source_labels_ = std::move(clusters.source_labels);
  report_ = std::move(report);
  return std::move(clusters.patches);
}

double
PlaneClusteringParameters::secondsOf(const acmap::PointView& points,
                                     const acmap::PointView& normals) const
{
  bool has_normals = false;
  for (std::size_t i = 0; i < normals.size() && !has_normals; ++i)
    has_normals = normals[i].allFinite();
  if (points.size() == 0 || noise_driven_ || !has_normals)
    return 0;
  return acmap::secondsOfPaperGrowth(points, member_distance_);
}

namespace {

/** \return the values of a field in all rows; empty if there is none */
template <typename Value>
LargeVector<Value>
valuesOf(const CloudRows& rows, const char* name, std::uint8_t type)
{
  LargeVector<Value> values;
  const PCLPointField* const field = acmap::findField(rows.layout(), name, type);
  if (!field || rows.size() == 0)
    return values;
  values.resize(rows.size());
  const std::uint8_t* from = rows.data() + field->offset;
  for (Value& value : values) {
    std::memcpy(&value, from, sizeof value);
    from += rows.layout().point_step;
  }
  return values;
}

} // namespace

double
PlaneHypothesisClustering<PCLPointCloud2>::estimateSeconds() const
{
  if (!rows_)
    return 0;
  return secondsOf(acmap::requirePoints(rows_),
                   acmap::normalsOf(normals_ ? normals_ : rows_));
}

void
PlaneHypothesisClustering<PCLPointCloud2>::segment(std::vector<PlanePatch>& patches)
{
  acmap::PlaneHypotheses hypotheses = hypothesesOf(rows_, normals_);
  const std::size_t points = hypotheses.points.size();
  requireAsMany("normals", hypotheses.normals.size(), points);
  if (normals_) {
    hypotheses.curvatures =
        valuesOf<float>(normals_, "curvature", PCLPointField::FLOAT32);
    hypotheses.is_crease =
        valuesOf<std::uint8_t>(normals_, "vertex_class", PCLPointField::UINT8);
    for (std::uint8_t& value : hypotheses.is_crease)
      value = acmap::isCrease(value) ? 1 : 0;
  }
  patches = cluster(std::move(hypotheses), nullptr, points);
}

} // namespace pcl
