#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/mesh_input.h>
#include <pcl/features/normal_vector_voting.h>

#include <cstring>

namespace pcl {

void
VotingParameters::setTriangles(const std::vector<Vertices>& polygons)
{
  triangles_ = acmap::trianglesOf(polygons);
}

void
VotingParameters::setRadiusSearch(double radius)
{
  acmap::requireInRange("search radius", radius, 0.0, 1e9, "m (0 = automatic)");
  settings_.radius = radius;
}

void
VotingParameters::setCreaseWeight(double eps)
{
  acmap::requireInRange("crease weight", eps, 1e-6, 1e6, "(no unit)");
  settings_.crease_weight = eps;
}

void
VotingParameters::setCornerWeight(double eta)
{
  acmap::requireInRange("corner weight", eta, 1e-6, 1e6, "(no unit)");
  settings_.corner_weight = eta;
}

void
VotingParameters::setViewpoints(std::vector<Eigen::Vector3f> viewpoints)
{
  acmap::requireViewpoints(viewpoints);
  viewpoints_ = std::move(viewpoints);
}

acmap::VotingSettings
VotingParameters::settings() const
{
  acmap::VotingSettings settings = settings_;
  settings.threads = threads_;
  return settings;
}

namespace {

/** Rows of normals as \ref NormalVectorVoting<PCLPointCloud2>::compute returns them. */
CloudRows
rowsOfVotes(const LargeVector<acmap::VotedNormal>& votes)
{
  std::vector<acmap::FieldWish> fields;
  for (const char* name : acmap::normal_field_names)
    fields.push_back({name, PCLPointField::FLOAT32});
  fields.push_back({"curvature", PCLPointField::FLOAT32});
  fields.push_back({"vertex_class", PCLPointField::UINT8});
  PCLPointCloud2 layout = acmap::layoutWith(PCLPointCloud2(), fields);
  layout.is_dense = 1;
  LargeVector<std::uint8_t> rows(votes.size() * layout.point_step);
  std::uint8_t* row = rows.data();
  for (const acmap::VotedNormal& voted : votes) {
    const float values[] = {
        voted.normal[0], voted.normal[1], voted.normal[2], 1 - voted.saliency};
    std::memcpy(row, values, sizeof values);
    row[sizeof values] = static_cast<std::uint8_t>(voted.vertex_class);
    if (voted.vertex_class == VertexClass::Unknown)
      layout.is_dense = 0;
    row += layout.point_step;
  }
  return {std::move(layout), std::move(rows)};
}

} // namespace

void
NormalVectorVoting<PCLPointCloud2>::setSensorOrigin(const Eigen::Vector3f& origin)
{
  acmap::requireViewpoints({origin});
  sensor_origin_ = origin;
}

acmap::SensorView
NormalVectorVoting<PCLPointCloud2>::sensors() const
{
  if (!viewpoints_.empty())
    return acmap::sensorsOf(rows_, viewpoints_, std::nullopt);
  return sensor_origin_ ? acmap::SensorView(*sensor_origin_) : acmap::SensorView();
}

void
NormalVectorVoting<PCLPointCloud2>::compute(CloudRows& output)
{
  const acmap::PointView points = acmap::requirePoints(rows_);
  acmap::requireCornersInside(triangles_, points.size());
  VotingReport report;
  output = rowsOfVotes(
      acmap::voteNormals(
          points, triangles_, sensors(), settings(), acmap::Progress(progress_), report)
          .normals);
  report_ = std::move(report);
}

} // namespace pcl
