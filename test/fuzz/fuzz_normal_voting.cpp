#include "fuzzed_mesh.h"

#include <pcl/features/impl/voting_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl::acmap::test {
namespace {

constexpr std::size_t max_points = 48;

/** A mesh with the settings of its voting. */
struct VotingTask {
  PointStyle style;
  FuzzedMesh mesh;
  std::vector<std::int32_t> views;
  SensorView sensors;
  VotingSettings settings;

  explicit VotingTask(FuzzedBytes bytes)
  : style(bytes)
  , mesh(bytes, style, max_points)
  , sensors(fuzzedSensors(bytes, style, mesh.points.size(), views))
  {
    const std::uint8_t choice = bytes.byte();
    settings.compute_curvatures = choice & 1;
    settings.threads = choice >= 0xf0 ? 2 : 1;
    settings.radius = std::min(0.25 * bytes.byte() * style.scale, 1e9);
    if (choice & 2)
      settings.crease_weight = (1 + bytes.byte()) / 8.0;
    if (choice & 4)
      settings.corner_weight = (1 + bytes.byte()) / 32.0;
  }
};

VotedNormals
vote(const VotingTask& task,
     const TriangleMesh::Triangles& triangles,
     VotingReport& report)
{
  return voteNormals(viewOf(task.mesh.points),
                     triangles,
                     task.sensors,
                     task.settings,
                     Progress(),
                     report);
}

bool
isUnit(const Eigen::Vector3f& direction)
{
  return std::abs(direction.norm() - 1) < 1e-4F;
}

bool
isNothing(const Eigen::Vector3f& direction)
{
  return direction.array().isNaN().all();
}

void
requireSound(const VotedNormal& voted)
{
  if (voted.vertex_class == VertexClass::Unknown) {
    require(isNothing(voted.normal) && isNothing(voted.direction));
    require(std::isnan(voted.saliency));
    return;
  }
  require(isUnit(voted.normal) && isUnit(voted.direction));
  require(std::abs(voted.normal.dot(voted.direction)) < 1e-3F);
  require(voted.saliency >= 0 && voted.saliency <= 1 + 1e-5F);
}

/** Curvatures are only known on surfaces with votes from sufficiently many
 * directions. */
void
requireSound(const VotedCurvature& curvature, const VotedNormal& voted)
{
  if (isNothing(curvature.direction)) {
    require(std::isnan(curvature.first) && std::isnan(curvature.second));
    return;
  }
  require(voted.vertex_class == VertexClass::Surface);
  require(isUnit(curvature.direction));
  require(std::abs(curvature.direction.dot(voted.normal)) < 1e-3F);
  require(std::isfinite(curvature.first) && std::isfinite(curvature.second));
  require(std::abs(curvature.first) >= std::abs(curvature.second));
}

void
requireTurned(const VotingTask& task, std::size_t v, const VotedNormal& voted)
{
  const Eigen::Vector3f* sensor = task.sensors[v];
  if (sensor && voted.vertex_class != VertexClass::Unknown)
    require(!(voted.normal.dot(*sensor - task.mesh.points[v]) < 0));
}

void
requireTrueReport(const VotingTask& task,
                  const VotedNormals& found,
                  const VotingReport& report)
{
  const auto count = [&](VertexClass vertex_class) {
    return static_cast<std::size_t>(std::count_if(
        found.normals.begin(), found.normals.end(), [&](const VotedNormal& voted) {
          return voted.vertex_class == vertex_class;
        }));
  };
  require(report.vertices == task.mesh.points.size());
  require(report.triangles == task.mesh.triangles.size());
  require(report.degenerate_triangles <= report.triangles);
  require(report.surface == count(VertexClass::Surface));
  require(report.crease == count(VertexClass::Crease));
  require(report.corner == count(VertexClass::Corner));
  require(report.unknown == count(VertexClass::Unknown));
  require(report.unknown == 0 || !report.remarks.empty());
}

template <typename Value>
bool
areSameBytes(const Value& a, const Value& b)
{
  return std::memcmp(&a, &b, sizeof(Value)) == 0;
}

/** Triangles without area or with invalid points change nothing, and neither does
 * another number of threads. */
void
requireSameOfUsable(const VotingTask& task, const VotedNormals& found)
{
  const std::vector<Eigen::Vector3f>& points = task.mesh.points;
  TriangleMesh::Triangles usable;
  for (const TriangleMesh::Triangle& t : task.mesh.triangles)
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && points[t[0]].allFinite() &&
        points[t[1]].allFinite() && points[t[2]].allFinite())
      usable.push_back(t);
  VotingTask once = task;
  once.settings.threads = 1;
  VotingReport report;
  const VotedNormals again = vote(once, usable, report);
  for (std::size_t v = 0; v < points.size(); ++v) {
    const VotedNormal &a = found.normals[v], &b = again.normals[v];
    require(a.vertex_class == b.vertex_class && areSameBytes(a.normal, b.normal) &&
            areSameBytes(a.direction, b.direction) &&
            areSameBytes(a.saliency, b.saliency));
    if (task.settings.compute_curvatures)
      require(areSameBytes(found.curvatures[v], again.curvatures[v]));
  }
}

void
voteFuzzed(const VotingTask& task)
{
  VotingReport report;
  const VotedNormals found = vote(task, task.mesh.triangles, report);
  const std::size_t size = task.mesh.points.size();
  require(found.normals.size() == size);
  require(found.curvatures.size() == (task.settings.compute_curvatures ? size : 0));
  for (std::size_t v = 0; v < size; ++v) {
    requireSound(found.normals[v]);
    requireTurned(task, v, found.normals[v]);
    if (task.settings.compute_curvatures)
      requireSound(found.curvatures[v], found.normals[v]);
  }
  requireTrueReport(task, found, report);
  requireSameOfUsable(task, found);
}

} // namespace
} // namespace pcl::acmap::test

/** Any mesh gets normals with the guarantees of NormalVectorVoting. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace pcl::acmap::test;
  voteFuzzed(VotingTask(FuzzedBytes(data, size)));
  return 0;
}
