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
  settings_.member_distance = distance;
}

void
PlaneClusteringParameters::setSmoothnessThreshold(double angle)
{
  acmap::requireInRange("smoothness threshold W_n", angle, 1e-6, M_PI / 2, "rad");
  settings_.normal_angle = angle;
}

void
PlaneClusteringParameters::setDistanceThreshold(double distance)
{
  acmap::requireInRange("distance threshold W_t", distance, 1e-9, 1e9, "m");
  settings_.plane_distance = distance;
}

std::optional<double>
PlaneClusteringParameters::getDistanceThreshold() const
{
  if (settings_.plane_distance || settings_.noise_driven)
    return settings_.plane_distance;
  return acmap::paper_plane_distance;
}

void
PlaneClusteringParameters::setMinArea(double area)
{
  acmap::requireInRange("minimum area", area, 0.0, 1e12, "m^2 (0 = automatic)");
  settings_.min_area = area;
}

acmap::PlaneClusteringSettings
PlaneClusteringParameters::settings() const
{
  acmap::PlaneClusteringSettings settings = settings_;
  settings.threads = threads_;
  return settings;
}

std::vector<PlanePatch>
PlaneClusteringParameters::cluster(acmap::PlaneHypotheses hypotheses,
                                   const std::vector<std::int32_t>* chosen,
                                   std::size_t points)
{
  hypotheses.triangles = triangles_;
  if (chosen)
    acmap::keepChosen(*chosen, points, hypotheses);
  PlaneClusteringReport report;
  acmap::PlaneClusters clusters =
      acmap::clusterPlanes(hypotheses,
                           {source_points_, source_sensors_, has_known_sensors_},
                           settings(),
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
  if (points.size() == 0 || settings_.noise_driven || !has_normals)
    return 0;
  return acmap::secondsOfPaperGrowth(points, settings_.member_distance);
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
