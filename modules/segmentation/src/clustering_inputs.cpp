#include <pcl/core/exceptions.h>
#include <pcl/core/impl/mesh_input.h>
#include <pcl/segmentation/clustering_inputs.h>

namespace pcl {

void
ClusteringInputs::setTriangles(const std::vector<Vertices>& polygons)
{
  triangles_ = acmap::trianglesOf(polygons);
}

void
ClusteringInputs::setSourceCloud(const CloudRows& cloud,
                                 const std::vector<Eigen::Vector3f>& viewpoints)
{
  acmap::requireViewpoints(viewpoints);
  source_ = std::make_shared<const CloudRows>(cloud);
  source_points_ = cloud ? acmap::requirePoints(cloud) : acmap::PointView();
  source_sensors_ = cloud && !viewpoints.empty()
                        ? acmap::sensorsOf(cloud, viewpoints, viewpoints.front())
                        : acmap::SensorView();
  has_known_sensors_ = source_sensors_.isKnown();
  viewpoints_ = cloud ? viewpoints : std::vector<Eigen::Vector3f>();
}

acmap::SensorView
ClusteringInputs::pointSensors(const CloudRows& points) const
{
  if (viewpoints_.size() == 1)
    return acmap::SensorView(viewpoints_.front());
  return viewpoints_.empty() ? acmap::SensorView()
                             : acmap::sensorsOf(points, viewpoints_, std::nullopt);
}

acmap::PlaneHypotheses
ClusteringInputs::hypothesesOf(const CloudRows& points, const CloudRows& normals) const
{
  acmap::PlaneHypotheses hypotheses;
  hypotheses.points = acmap::requirePoints(points);
  const std::size_t size = hypotheses.points.size();
  acmap::requireCornersInside(triangles_, size);
  const acmap::PointView given = acmap::normalsOf(normals ? normals : points);
  if (normals)
    requireAsMany("normals", given.size(), size);
  hypotheses.normals = acmap::unitNormals(given);
  hypotheses.sensors = pointSensors(points);
  return hypotheses;
}

void
ClusteringInputs::requireAsMany(const char* what,
                                std::size_t number,
                                std::size_t points)
{
  if (number != points)
    throw acmap::InitFailed(
        "there are ", number, " ", what, " for ", points, " points");
}

void
ClusteringInputs::keepLabels(PointLabels of_hypotheses,
                             const std::vector<std::int32_t>* chosen,
                             std::size_t points)
{
  if (!chosen) {
    labels_ = std::move(of_hypotheses);
    return;
  }
  labels_.assign(points, -1);
  for (std::size_t i = 0; i < chosen->size(); ++i)
    labels_[static_cast<std::size_t>((*chosen)[i])] = of_hypotheses[i];
}

} // namespace pcl
