#include "face_edges.h"
#include "fuzzed_points.h"
#include "mesh_completeness.h"

#include <pcl/surface/impl/dewall_kernel.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace pcl::acmap::test {
namespace {

/** Completeness is checked with all triples of points, so only for few points. */
constexpr std::size_t max_points = 40, max_judged = 12;

/** A cloud with the settings of its mesh. */
struct DeWallTask {
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f> normals;
  DeWallSettings settings;
  DeWallInput input;
  bool is_moderate = false;

  explicit DeWallTask(FuzzedBytes bytes)
  {
    constexpr DeWallRule rules[] = {DeWallRule::Guarded,
                                    DeWallRule::Dense,
                                    DeWallRule::Guarded,
                                    DeWallRule::Strict};
    constexpr std::int32_t leaf_sizes[] = {0, 8, 16, 20};
    const std::uint8_t choice = bytes.byte();
    settings.rule = rules[choice & 3];
    settings.leaf_size = leaf_sizes[choice >> 2 & 3];
    input.is_single_view = choice & 16;
    settings.compute_wall_depth = choice & 32;
    input.threads = choice >= 0xf0 ? 2 : 1;
    if (choice & 128)
      settings.up = Eigen::Vector3d::UnitZ();
    const bool has_normals = choice & 64;
    const PointStyle style(bytes);
    is_moderate = style.isModerate();
    settings.maximum_edge_length = // converted to float, as in the kernel
        std::min(0.25F * static_cast<float>(bytes.byte()) * style.scale, 1e9F);
    for (int axis = 0; axis < 3; ++axis)
      input.sensor_origin[axis] = style.coordinate(bytes);
    points = fuzzedPoints(bytes, style, max_points);
    if (has_normals) {
      while (normals.size() < points.size())
        normals.push_back(fuzzedNormal(bytes));
      input.normals = viewOf(normals);
    }
    input.points = viewOf(points);
  }
};

Points
inDoubles(const std::vector<Eigen::Vector3f>& points)
{
  Points result;
  for (const Eigen::Vector3f& point : points)
    result.push_back(point.cast<double>());
  return result;
}

bool
isGuarded(const DeWallTask& task)
{
  return task.settings.rule != DeWallRule::Strict;
}

double
longestAllowed(const DeWallTask& task, const DeWallReport& report)
{
  const double length = task.settings.maximum_edge_length;
  return length > 0 ? length : report.largest_maximum_edge;
}

void
requireSound(const DeWallTask& task,
             const Points& points,
             const TriangleMesh& mesh,
             const DeWallReport& report)
{
  MeshDemands demands;
  demands.edge_allowed = noLongerThan(points, longestAllowed(task, report));
  demands.empty_spheres = task.settings.rule != DeWallRule::Dense;
  demands.sphere_tolerance = 1e-5;  // the sphere of a flat triangle is not more
                                    // accurate
  demands.min_area_ratio = 0.9e-10; // the kernel's threshold with a tolerance for
                                    // rounding
  MeshFaults faults = checkMesh(points, mesh.triangles, demands);
  require(report.crowded_edges == faults.crowded_edges);
  if (!isGuarded(task))
    faults.crowded_edges = faults.torn_vertices = faults.inconsistent_edges = 0;
  if (faults.total() > 0)
    std::cerr << faults << '\n';
  require(faults.total() == 0);
  if (task.settings.compute_wall_depth)
    require(mesh.wall_depth.size() == mesh.triangles.size());
}

void
requireTrueReport(const DeWallTask& task,
                  const Points& points,
                  const TriangleMesh& mesh,
                  const DeWallReport& report)
{
  const MeshCounts counts = countMesh(points, mesh.triangles);
  const auto finite = static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(), [](const auto& p) { return p.allFinite(); }));
  require(report.points == points.size());
  require(report.invalid_points == points.size() - finite);
  require(report.duplicate_points == finite - usablePoints(task.points).size());
  require(report.triangles == counts.faces);
  require(report.used_points == counts.used_points);
  require(report.edges == counts.edges);
  require(report.boundary_edges == counts.boundary_edges);
  require(report.components == counts.components);
  require(!mesh.triangles.empty() || !report.remarks.empty());
}

/** More of each component's front than of its back faces the sensor. */
void
requireFacing(const DeWallTask& task, const Points& points, const TriangleMesh& mesh)
{
  const Eigen::Vector3d& sensor = task.input.sensor_origin;
  if (!isGuarded(task) || task.input.is_single_view || task.settings.up ||
      !task.normals.empty() || !task.is_moderate || !sensor.allFinite())
    return;
  Eigen::VectorXd front = Eigen::VectorXd::Zero(points.size()), whole = front;
  FaceSets components(points.size());
  for (const Triangle& face : mesh.triangles) {
    components.unite(face[0], face[1]);
    components.unite(face[0], face[2]);
  }
  for (const Triangle& face : mesh.triangles) {
    const Eigen::Vector3d &a = points[face[0]], &b = points[face[1]],
                          &c = points[face[2]];
    const Eigen::Vector3d area = (b - a).cross(c - a);
    const Eigen::Vector3d view = sensor - (a + b + c) / 3;
    if (view.norm() < 1e-6 * sensor.norm())
      return; // inside a face: it may see either side
    front[components.find(face[0])] += area.dot(view.normalized());
    whole[components.find(face[0])] += area.norm();
  }
  require((front.array() >= -1e-9 * whole.array()).all());
}

/** No further triangle can be added. */
void
requireComplete(const DeWallTask& task,
                const Points& points,
                const TriangleMesh& mesh,
                const DeWallReport& report)
{
  if (!isGuarded(task) || !task.is_moderate || points.size() > max_judged)
    return;
  // duplicate points would get a mesh of their own
  Points judged(points.size(), Points::value_type::Constant(std::nan("")));
  for (const std::int32_t i : usablePoints(task.points))
    judged[i] = points[i];
  CompletenessRule rule;
  rule.edge_allowed = noLongerThan(judged, longestAllowed(task, report));
  rule.turn_limit = M_PI / 2;
  require((task.settings.rule == DeWallRule::Guarded
               ? missingUnderPaperRule(judged, mesh.triangles, rule)
               : missingUnderDenseRule(judged, mesh.triangles, rule))
              .empty());
}

/** Unusable points change nothing, and neither does a second run. */
void
requireSameOfUsable(const DeWallTask& task, const TriangleMesh& mesh)
{
  const std::vector<std::int32_t> usable = usablePoints(task.points);
  DeWallInput input = task.input;
  input.points = PointView(
      task.points.data(), sizeof(Eigen::Vector3f), usable.size(), usable.data());
  input.threads = 1;
  DeWallReport report;
  const TriangleMesh again =
      triangulateDeWall(input, task.settings, Progress(), report);
  require(again.triangles == mesh.triangles && again.wall_depth == mesh.wall_depth);
}

void
meshFuzzed(const DeWallTask& task)
{
  DeWallReport report;
  const TriangleMesh mesh =
      triangulateDeWall(task.input, task.settings, Progress(), report);
  const Points points = inDoubles(task.points);
  requireSound(task, points, mesh, report);
  requireTrueReport(task, points, mesh, report);
  requireFacing(task, points, mesh);
  requireComplete(task, points, mesh, report);
  requireSameOfUsable(task, mesh);
}

} // namespace
} // namespace pcl::acmap::test

/** Any points give a mesh with the guarantees of DeWallTriangulation. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace pcl::acmap::test;
  meshFuzzed(DeWallTask(FuzzedBytes(data, size)));
  return 0;
}
