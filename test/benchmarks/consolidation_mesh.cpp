#include "bench.h"
#include "mesh_checker.h"
#include "meshes.h"
#include "scene_truth.h"

namespace pcl::acmap::bench {
namespace {

/** Targets for a mesh. */
struct MeshReach {
  double median, p95;           // degrees
  double cover, area, boundary; // percent
};

constexpr MeshReach whole_reach{0.7, 5, 97, 2, 1.5};
constexpr MeshReach view_reach{1.2, 6, 97, 3, 2.5};
constexpr MeshReach sparse_reach{no_reach, no_reach, 95, no_reach, 4};

struct MeasuredMesh {
  double voxel; // metres
  std::size_t representatives, triangles;
  MeshFigures figures;
};

MeasuredMesh
meshAndMeasure(const SimulatedCloud& cloud, double voxel, const SceneTruth& truth)
{
  ConsolidationReport report;
  const Consolidation consolidation = consolidate(cloud, voxel, report);
  const test::Triangles mesh = meshOf(consolidation, report.voxel_size).triangles;
  return {
      report.voxel_size,
      consolidation.representatives.size(),
      mesh.size(),
      measureMesh(truth, placesInScene(cloud, consolidation), mesh, report.voxel_size)};
}

void
printMesh(const SimulatedCloud& cloud,
          double voxel,
          const SceneTruth& truth,
          const MeshReach& reach)
{
  const MeasuredMesh mesh = meshAndMeasure(cloud, voxel, truth);
  const MeshFigures& figures = mesh.figures;
  Row() << cloud.name + ", " + voxelName(voxel) << figure(centi * mesh.voxel, 1)
        << mesh.representatives << mesh.triangles
        << atMost(figures.normals.median_away, reach.median, 2)
        << atMost(figures.normals.p95_away, reach.p95, 1)
        << figure(figures.normals.backs_away, 2)
        << atMost(figures.normals.median_all, reach.median, 2)
        << figure(figures.normals.p95_all, 1) << figure(figures.normals.backs_all, 2)
        << atLeast(figures.cover, reach.cover, 2) << figure(figures.overlap, 1)
        << within(figures.area, reach.area, 2)
        << atMost(figures.boundary, reach.boundary, 2);
}

const Section mesh_section("mesh", [] {
  printHead("cloud, voxel | cm | representatives | triangles | face normals away from "
            "creases, median ° | p95 ° | backs % | all faces, median ° | p95 ° | backs "
            "% | cover % | covered twice % | area % | boundary edges %");
  for (const std::size_t view : {0, 40, 53})
    printMesh(makeViewCloud(corridor().scene(), view),
              0,
              corridor().truthOfView(view),
              view_reach);
  const SimulatedCloud& whole = corridor().whole();
  const SceneTruth& truth = corridor().wholeTruth();
  for (const std::size_t size : {100000, 1000000})
    printMesh(makeRandomPart(whole, size, size), 0, truth, sparse_reach);
  for (const double voxel : {0.05, 0.0})
    printMesh(whole, voxel, truth, whole_reach);
});

const Section every_view_section("mesh", [] {
  std::vector<MeshFigures> views;
  for (std::size_t view = 0; view < corridor().scene().views.size(); ++view)
    views.push_back(meshAndMeasure(makeViewCloud(corridor().scene(), view),
                                   0,
                                   corridor().truthOfView(view))
                        .figures);
  // larger values are worse
  const auto print = [&](const char* name, double reach, const auto& property) {
    const std::vector<double> values = valuesOf(views, property);
    Row() << name << figure(median(values), 2) << atMost(largest(values), reach, 2)
          << std::count_if(
                 values.begin(), values.end(), [&](double v) { return !(v <= reach); });
  };
  using Figures = const MeshFigures&;
  printHead("figure | median view | worst view | views that miss");
  print("all faces, median °", view_reach.median, [](Figures view) {
    return view.normals.median_all;
  });
  print("faces away from creases, p95 °", view_reach.p95, [](Figures view) {
    return view.normals.p95_away;
  });
  print("not covered %", 100 - view_reach.cover, [](Figures view) {
    return 100 - view.cover;
  });
  print("area, off by %", view_reach.area, [](Figures view) {
    return std::abs(view.area);
  });
  print("boundary edges %", view_reach.boundary, [](Figures view) {
    return view.boundary;
  });
});

using Raster = std::vector<std::uint8_t>;

bool
isClear(const SceneTruth& truth,
        const TruthSurface& surface,
        const Eigen::Vector3d& point,
        double voxel)
{
  return truth.distanceToOthers(point, surface, false) > creaseMargin(voxel);
}

/** Representatives belong to the nearest surface; each one covers the area within a voxel
 * along the surface if its distance to the surface is at most 3 cm. Judged are those of
 * one plane, except near other planes that are not parallel to it. */
void
printSheet(const SceneTruth& truth,
           std::int32_t plane,
           const test::Points& places,
           const test::Points& normals,
           double voxel,
           Row& row)
{
  constexpr double near = 0.03, depth_reach = 5,
                   cover_reach = 97; // metres, mm, percent
  const std::vector<TruthSurface>& surfaces = truth.surfaces();
  std::vector<Raster> rasters;
  for (const TruthSurface& surface : surfaces)
    rasters.emplace_back(surface.plane == plane ? surface.visible.size() : 0, 0);
  std::size_t turned = 0;
  std::vector<double> depth_errors, shifts;
  for (std::size_t r = 0; r < places.size(); ++r) {
    const TruthSurface& surface = truth.nearest(places[r]);
    if (surface.plane != plane)
      continue;
    const Eigen::Vector3d place = surface.coordinates(places[r]);
    const bool is_turned = !(normals[r].dot(surface.normal) > 0);
    Raster& raster = rasters[static_cast<std::size_t>(&surface - surfaces.data())];
    if (!is_turned && std::abs(place[2]) <= near)
      surface.visitCells(place, voxel, [&](int i, int j) {
        const Eigen::Vector3d off = surface.cellCenter(i, j) - places[r];
        if (std::hypot(off.dot(surface.unit_u), off.dot(surface.unit_v)) <= voxel)
          raster[surface.cellIndex(i, j)] = 1;
      });
    if (!isClear(truth, surface, places[r], voxel))
      continue;
    depth_errors.push_back(std::abs(place[2]));
    shifts.push_back(place[2]);
    turned += is_turned;
  }
  std::size_t visible = 0, covered = 0;
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    if (surfaces[s].plane == plane)
      for (int i = 0; i < surfaces[s].cells[0]; ++i)
        for (int j = 0; j < surfaces[s].cells[1]; ++j) {
          const std::size_t cell = surfaces[s].cellIndex(i, j);
          if (!surfaces[s].visible[cell] ||
              !isClear(truth, surfaces[s], surfaces[s].cellCenter(i, j), voxel))
            continue;
          ++visible;
          covered += rasters[s][cell];
        }
  row << shifts.size() << atLeast(percent(covered, visible), cover_reach, 1)
      << atMost(milli * meanOf(depth_errors), depth_reach, 2)
      << figure(milli * quantile(depth_errors, 0.95), 1)
      << within(milli * meanOf(shifts), depth_reach, 2)
      << figure(percent(turned, shifts.size()), 2);
}

std::int32_t
planeNamed(const SimulatedScene& scene, const std::string& name)
{
  const auto& planes = scene.geometry.planes();
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (planes[i].name == name)
      return static_cast<std::int32_t>(i);
  throw BadArgumentException("scene '" + scene.name + "' has no plane '" + name + "'");
}

void
printRows(SceneData& data, const std::vector<std::string>& planes)
{
  for (const double voxel : {0.04, 0.05, 0.07, 0.0}) {
    ConsolidationReport report;
    const SimulatedCloud& cloud = data.whole();
    const Consolidation consolidation = consolidate(cloud, voxel, report);
    const test::Points places = placesInScene(cloud, consolidation);
    const test::Points normals = normalsInScene(cloud, consolidation);
    for (const std::string& plane : planes) {
      Row row;
      row << plane << voxelName(voxel) << figure(centi * report.voxel_size, 1);
      printSheet(data.wholeTruth(),
                 planeNamed(data.scene(), plane),
                 places,
                 normals,
                 report.voxel_size,
                 row);
    }
  }
}

const Section sheets_section("sheets", [] {
  printHead("sheet | voxel | cm | representatives | kept: covered % | depth error, "
            "mean mm | p95 mm | shift, mm | turned %");
  SceneData office("office");
  printRows(office, {"partition left", "partition right"});
  printRows(corridor(), {"doors left", "left wall", "doors right", "right wall"});
});

} // namespace
} // namespace pcl::acmap::bench
