#include "plane_stages.h"

#include "memory.h"
#include "plane_reports.h"
#include "stage_reports.h"

#include <pcl/surface/dewall_kernel.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

PointView
normalsOf(const std::vector<Representative>& all)
{
  return all.empty() ? PointView()
                     : PointView(all.front().normal.data(), sizeof all[0], all.size());
}

PlaneHypotheses
hypothesesOf(const HypothesisMesh& mesh)
{
  PlaneHypotheses hypotheses;
  hypotheses.points = mesh.vertices.points();
  hypotheses.triangles = mesh.mesh.triangles;
  for (const VotedNormal& voted : mesh.votes.normals) {
    hypotheses.normals.push_back(voted.normal);
    hypotheses.curvatures.push_back(1 - voted.saliency);
    hypotheses.is_crease.push_back(voted.vertex_class >= VertexClass::Crease ? 1 : 0);
  }
  return hypotheses;
}

HypothesisMesh
triangulate(Tool& tool, PointCloudFile file, DeWallSettings settings)
{
  requireMemory(estimateDeWallMemory(file.points().size(), true),
                "triangulating this cloud");
  settings.threads = tool.threads();
  settings.sensor_origin = file.sensor_origin.cast<double>();
  DeWallReport report;
  HypothesisMesh result;
  tool.withProgress([&](const ProgressCallback& progress) {
    result.mesh =
        triangulateDeWall(file.points(), settings, Progress(progress), report);
  });
  for (const std::string& remark : report.remarks)
    tool.warn(remark);
  tool.details()["mesh"] = jsonOf(report);
  result.vertices = std::move(file);
  result.spacing = report.median_spacing;
  return result;
}

/** Without normals no plane begins to grow. */
bool
hasNormals(const HypothesisMesh& mesh)
{
  return std::any_of(mesh.votes.normals.begin(),
                     mesh.votes.normals.end(),
                     [](const VotedNormal& voted) { return voted.normal.allFinite(); });
}

} // namespace

HypothesisMesh
meshAsItIs(Tool& tool, const PointCloudFile& file)
{
  return triangulate(tool, file, {});
}

HypothesisMesh
meshConsolidated(Tool& tool, ConsolidatedCloud cloud, double voxel_size)
{
  DeWallSettings settings;
  settings.maximum_edge_length = edges_of_voxel * voxel_size;
  settings.normals = normalsOf(cloud.consolidation.representatives);
  return triangulate(tool, std::move(cloud.file), settings);
}

void
voteOnMesh(Tool& tool, HypothesisMesh& mesh, const SensorView& sensors)
{
  VotingSettings settings;
  settings.threads = tool.threads();
  VotingReport report;
  tool.withProgress([&](const ProgressCallback& progress) {
    mesh.votes = voteNormals(mesh.vertices.points(),
                             mesh.mesh.triangles,
                             sensors,
                             settings,
                             Progress(progress),
                             report);
  });
  if (mesh.spacing == 0)
    mesh.spacing = report.mean_edge;
  tool.details()["votes"] = jsonOf(report);
}

double
secondsOfPaperGrowth(const PointView& points, double member_distance)
{
  constexpr std::size_t samples = 200;
  // of a noisy view, on a processor of 2020; clear planes take a twentieth: their points
  // are looked at twice only
  constexpr double seconds_a_pair = 120e-9;
  const std::size_t step = 1 + points.size() / samples;
  double pairs = 0, sampled = 0;
  for (std::size_t i = 0; i < points.size(); i += step, ++sampled)
    for (std::size_t k = 0; k < points.size(); ++k)
      pairs += (points[i] - points[k]).squaredNorm() <
               static_cast<float>(member_distance * member_distance);
  return seconds_a_pair * pairs * static_cast<double>(points.size()) /
         std::max(1.0, sampled);
}

PlaneClusters
findPlanes(Tool& tool,
           const HypothesisMesh& mesh,
           const PlaneSource& source,
           PlaneClusteringSettings settings)
{
  settings.threads = tool.threads();
  PlaneClusteringReport report;
  PlaneClusters clusters;
  constexpr double long_time = 60; // seconds
  const double seconds =
      settings.noise_driven || !hasNormals(mesh)
          ? 0
          : secondsOfPaperGrowth(mesh.vertices.points(), settings.member_distance);
  if (seconds > long_time)
    tool.warnAtOnce("the paper's clustering looks at all pairs of points within " +
                    shortNumber(settings.member_distance) + " m: with " +
                    std::to_string(mesh.vertices.points().size()) +
                    " points that may take about " +
                    std::to_string(std::lround(seconds / 60)) +
                    " min; a larger voxel (--consolidate M) shortens it, and without "
                    "--paper it takes seconds");
  tool.withProgress([&](const ProgressCallback& progress) {
    clusters =
        clusterPlanes(hypothesesOf(mesh), source, settings, Progress(progress), report);
  });
  for (const std::string& remark : report.remarks)
    tool.warn(remark);
  tool.details()["report"] = jsonOf(report);
  return clusters;
}

} // namespace pcl::acmap
