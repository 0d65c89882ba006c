#include "dewall_runs.h"

#include <pcl/surface/impl/dewall_kernel.h>

#include <algorithm>

namespace pcl::acmap::test {
namespace {

constexpr double quarter = 90.0 / 180.0 * 3.14159265358979323846;

std::vector<DeWallCase>
makeSheetCases()
{
  const auto sampling = [](double noise) {
    return SheetSampling{45, 45, 0.02, 0.25, noise, 11};
  };
  return {
      {"plane", makeJitteredPlane(sampling(0)).cloud, 0.06},
      {"plane_noise_01", makeJitteredPlane(sampling(0.1)).cloud, 0.06},
      {"plane_noise_05", makeJitteredPlane(sampling(0.5)).cloud, 0.06},
      {"plane_slab", makeJitteredPlane(sampling(2)).cloud, 0.06},
      {"plane_automatic", makeJitteredPlane(sampling(0.2)).cloud, 0},
      {"rising_edge", makeFoldedPlane(sampling(0.1), quarter).cloud, 0.06},
      {"falling_edge", makeFoldedPlane(sampling(0.1), -quarter).cloud, 0.06},
      {"graded_plane", makeGradedPlane({60, 60, 0.01, 0.2, 0.05, 5}, 10).cloud, 0},
      {"sphere_cap", makeSphereCap(sampling(0.05), 0.5).cloud, 0.05},
      {"parallel_sheets", makeParallelSheets({25, 25, 0.02, 0.25, 0.1, 3}, 0.03), 0.05},
      {"merging_sheets", makeParallelSheets({25, 25, 0.02, 0.25, 0.1, 3}, 0.01), 0.05},
      {"corner", makeCorner({20, 20, 0.02, 0.25, 0.1, 3}), 0.06},
      {"room", makeRoom(0.1, 0.1, 4), 0.3},
  };
}

std::vector<DeWallCase>
makeOddCases()
{
  const Cloud sheet = makeJitteredPlane({20, 20, 0.02, 0.25, 0.1, 8}).cloud;
  return {
      {"grid_level", makeGrid(20, 20, 0.25, ExactPlane::Level), 0.5},
      {"grid_inclined", makeGrid(20, 20, 0.25, ExactPlane::Inclined), 0.75},
      {"grid_turned",
       moved(makeGrid(20, 20, 0.25, ExactPlane::Level), makeRandomMotion(3, 10)),
       0.6},
      {"grid_automatic", makeGrid(20, 20, 0.25, ExactPlane::Level), 0},
      {"grid_long_reach", makeGrid(20, 20, 0.25, ExactPlane::Level), 2},
      {"hexagonal_grid", makeHexagonalGrid(20, 20, 0.1), 0.15},
      {"random_level", makeRandomPlane(800, ExactPlane::Level, 6), 0.15},
      {"random_inclined", makeRandomPlane(800, ExactPlane::Inclined, 6), 0.15},
      {"circle", makeExactCircle(5, false), 6},
      {"circle_with_center", makeExactCircle(5, true), 6},
      {"random_box", makeRandomBox(600, 2), 0.2},
      {"moebius_band", makeMoebiusBand(60, 6, 1, 0.5, 7), 0.25},
      {"narrow_moebius_band", makeMoebiusBand(60, 2, 1, 0.1, 7), 0.25},
      {"doubled_points", doubled(sheet), 0.06},
      {"laced_with_nan", lacedWithNan(sheet, 3), 0.06},
      {"outlier", withOutlier(sheet, 1e9F), 0.06},
      {"outlier_automatic", withOutlier(sheet, 1e9F), 0},
      {"far_from_origin",
       moved(sheet, Eigen::Isometry3d(Eigen::Translation3d(1000, -2000, 500))),
       0.06},
      {"huge_units", scaled(sheet, 1e6F), 6e4},
      {"tiny_units", scaled(sheet, 1e-6F), 6e-8},
  };
}

std::vector<DeWallCase>
makeAllCases()
{
  std::vector<DeWallCase> cases = makeSheetCases();
  for (DeWallCase& odd : makeOddCases())
    cases.push_back(std::move(odd));
  return cases;
}

DeWallResult
withPoints(const Cloud& cloud)
{
  DeWallResult result;
  result.points = toPoints(cloud);
  return result;
}

} // namespace

const std::vector<DeWallCase>&
syntheticCases()
{
  static const std::vector<DeWallCase> cases = makeAllCases();
  return cases;
}

DeWallResult
triangulate(const Cloud& cloud, const DeWallRun& run)
{
  DeWallTriangulation<PointXYZ> dewall;
  dewall.setAcceptanceRule(run.rule);
  dewall.setMaximumEdgeLength(run.length);
  dewall.setNumberOfThreads(run.threads);
  dewall.setComputeWallDepth(run.depth);
  dewall.setInputCloud(cloud.makeShared());
  DeWallResult result = withPoints(cloud);
  dewall.reconstruct(result.mesh);
  result.report = dewall.getReport();
  return result;
}

DeWallResult
triangulateInLeaves(const Cloud& cloud, const DeWallRun& run, std::int32_t leaf_size)
{
  DeWallSettings settings;
  settings.rule = run.rule;
  settings.maximum_edge_length = run.length;
  settings.compute_wall_depth = run.depth;
  settings.leaf_size = leaf_size;
  DeWallInput input;
  input.points = PointView(cloud.data(), sizeof(PointXYZ), cloud.size());
  input.threads = run.threads;
  DeWallResult result = withPoints(cloud);
  result.mesh = triangulateDeWall(input, settings, Progress(), result.report);
  return result;
}

testing::AssertionResult
keepsGuarantees(const DeWallResult& result, const DeWallRun& run)
{
  MeshDemands demands;
  demands.edge_allowed = noLongerThan(
      result.points, run.length > 0 ? run.length : result.report.largest_maximum_edge);
  demands.empty_spheres = run.rule == DeWallRule::Guarded;
  const MeshFaults faults = checkMesh(result.points, result.mesh.triangles, demands);
  if (faults.total() > 0)
    return testing::AssertionFailure() << faults;
  const MeshCounts counts = countMesh(result.points, result.mesh.triangles);
  const DeWallReport& report = result.report;
  if (counts.faces != report.triangles || counts.edges != report.edges ||
      counts.boundary_edges != report.boundary_edges ||
      counts.components != report.components ||
      counts.used_points != report.used_points)
    return testing::AssertionFailure()
           << "the report tells " << report.triangles << " triangles, " << report.edges
           << " edges, " << report.boundary_edges << " of the boundary, "
           << report.components << " components, " << report.used_points
           << " points; counted " << counts.faces << ", " << counts.edges << ", "
           << counts.boundary_edges << ", " << counts.components << ", "
           << counts.used_points;
  return testing::AssertionSuccess();
}

Triangles
asSets(Triangles triangles)
{
  for (Triangle& triangle : triangles)
    std::sort(triangle.begin(), triangle.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

Triangles
asSets(const Triangles& triangles, const std::vector<std::int32_t>& names)
{
  Triangles renamed = triangles;
  for (Triangle& triangle : renamed)
    for (std::int32_t& corner : triangle)
      corner = names[corner];
  return asSets(std::move(renamed));
}

std::string
nameOf(DeWallRule rule)
{
  return rule == DeWallRule::Guarded ? "guarded"
                                     : (rule == DeWallRule::Dense ? "dense" : "strict");
}

} // namespace pcl::acmap::test
