#include "bench.h"
#include "clouds.h"
#include "mesh_peers.h"
#include "meshes.h"
#include "processes.h"
#include "scene_truth.h"
#include "simulated_clouds.h"

#include <pcl/simulation/standard_scenes.h>

#include <functional>
#include <optional>
#include <thread>

#ifdef ACMAP_HAVE_CGAL
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif

namespace pcl::acmap::bench {
namespace {

using test::Triangles;

constexpr double voxel = 0.05; // metres

/** A mesh of all views, and what it took. */
struct MapRun {
  std::size_t points = 0, triangles = 0, used_points = 0;
  double seconds = 0;
  std::size_t peak = 0; // bytes in addition to the input
};

MapRun
meshMap(DeWallRule rule)
{
  const SimulatedCloud cloud = makeSceneCloud(standardScene("corridor"));
  MapRun run;
  const PeakMemory memory;
  run.seconds = measureThread([&] {
    const RawMesh raw = meshRaw(cloud.points(), rule);
    run.triangles = raw.report.triangles;
    run.used_points = raw.report.used_points;
  });
  run.peak = memory.bytes();
  run.points = cloud.size();
  return run;
}

/** The first section: it forks, and the others start threads. */
const Section map_section("map", [] {
  printHead("mesher | points | triangles | CPU s | CPU us a point | points used % | "
            "peak on top of the input, bytes a point | GB");
  for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense}) {
    const MapRun run = runInChild([&] { return meshMap(rule); });
    const auto points = static_cast<double>(run.points);
    const auto peak = static_cast<double>(run.peak);
    Row() << ruleName(rule) << run.points << run.triangles << figure(run.seconds, 1)
          << figure(1e6 * run.seconds / points, 2)
          << figure(percent(run.used_points, run.points), 1) << figure(peak / points, 0)
          << figure(1e-9 * peak, 2);
  }
});

/** A view as a PCL cloud, with its truth. */
struct SpeedView {
  std::string name;
  test::Cloud cloud;
  SceneTruth truth;
  Eigen::Isometry3d T_scene_cloud;

  PointView
  points() const
  {
    return {cloud.front().data, sizeof(PointXYZ), cloud.size()};
  }
};

/** A meshing method for a view; methods that are only a lower bound return no mesh. */
struct SpeedMesher {
  std::string name;
  std::size_t rounds;
  std::function<std::optional<Triangles>()> mesh;
  std::vector<double> seconds = {};
  std::optional<Triangles> result = {};
};

#ifdef ACMAP_HAVE_CGAL
/** CGAL's 2D Delaunay triangulation of x and y, on one thread. */
std::optional<Triangles>
planarDelaunay(const PointView& points)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_2> flat;
  flat.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    flat.emplace_back(points[i].x(), points[i].y());
  const CGAL::Delaunay_triangulation_2<Kernel> mesh(flat.begin(), flat.end());
  return mesh.number_of_faces() > 0 ? std::nullopt : std::optional(Triangles());
}
#endif

std::vector<SpeedMesher>
speedMeshers(const SpeedView& view, std::size_t rounds)
{
  std::vector<SpeedMesher> all;
  for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense})
    all.push_back({ruleName(rule), rounds, [&view, rule] {
                     return meshRaw(view.points(), rule).mesh.triangles;
                   }});
#ifdef ACMAP_HAVE_CGAL
  all.push_back({"lower bound: CGAL 2D Delaunay of x and y", rounds, [&view] {
                   return planarDelaunay(view.points());
                 }});
#endif
  const double spacing = test::medianSpacing(test::toPoints(view.cloud));
  all.push_back({"PCL greedy projection", 1, [&view, spacing] {
                   return greedyProjection(view.cloud, spacing);
                 }});
  return all;
}

void
addMeshCells(const SpeedView& view, const SpeedMesher& mesher, Row& row)
{
  // Nearly all points are within three standard deviations of the largest noise.
  constexpr double tolerance = 0.09; // metres
  if (!mesher.result) {
    for (int cell = 0; cell < 6; ++cell)
      row << no_value;
    return;
  }
  const Triangles& mesh = *mesher.result;
  test::Points places = test::toPoints(view.cloud);
  const test::MeshCounts counts = test::countMesh(places, mesh);
  row << figure(percent(counts.used_points, view.cloud.size()), 1) << mesh.size()
      << figure(percent(counts.boundary_edges, counts.edges), 1);
  for (Eigen::Vector3d& place : places)
    place = view.T_scene_cloud * place;
  const MeshFigures figures = measureMesh(view.truth, places, mesh, 2 * tolerance);
  row << figure(figures.cover, 2) << figure(figures.overlap, 1)
      << figure(figures.area, 1);
}

void
printView(const SpeedView& view)
{
  constexpr std::size_t rounds = 5;
  std::vector<SpeedMesher> meshers = speedMeshers(view, rounds);
  for (std::size_t round = 0; round < rounds; ++round)
    for (SpeedMesher& mesher : meshers)
      if (round < mesher.rounds)
        mesher.seconds.push_back(measureThread([&] { mesher.result = mesher.mesh(); }));
  const double greedy = median(meshers.back().seconds);
  for (const SpeedMesher& mesher : meshers) {
    const double seconds = median(mesher.seconds);
    Row row;
    row << view.name << view.cloud.size() << mesher.name
        << figure(1e6 * seconds / static_cast<double>(view.cloud.size()), 2)
        << timesOf(greedy, seconds);
    addMeshCells(view, mesher, row);
  }
}

const Section view_section("view", [] {
  printHead(
      "view | points | mesher | CPU us a point | greedy projection takes | points "
      "used % | triangles | boundary edges % | cover % | covered twice % | area "
      "beyond the truth's %");
  const SimulatedCloud first = makeViewCloud(corridor().scene(), 0);
  printView({first.name,
             *plainPoints(first),
             corridor().truthOfView(0),
             first.T_scene_cloud});
});

const Section crops_section("crops", [] {
  constexpr std::size_t small_crop = 100000;
  printHead("piece | points | raw, CPU us a point | representatives, 5 cm | mesh of "
            "these, CPU us a representative");
  std::vector<double> raw, consolidated; // us per point
  const auto print = [&](const SimulatedCloud& cloud, std::size_t raw_rounds) {
    const std::size_t rounds = cloud.size() > small_crop ? 3 : 5;
    const auto each = [](double seconds, std::size_t points) {
      return 1e6 * seconds / static_cast<double>(points);
    };
    raw.push_back(
        each(medianThread(std::min(rounds, raw_rounds),
                          [&] { meshRaw(cloud.points(), DeWallRule::Guarded); }),
             cloud.size()));
    ConsolidationReport report;
    const Consolidation consolidation = consolidate(cloud, voxel, report);
    const std::size_t representatives = consolidation.representatives.size();
    consolidated.push_back(each(
        medianThread(rounds, [&] { meshOf(consolidation, voxel); }), representatives));
    Row() << cloud.name << cloud.size() << figure(raw.back(), 2) << representatives
          << figure(consolidated.back(), 2);
  };
  for (const std::size_t size : {small_crop, 10 * small_crop, 50 * small_crop})
    print(makeCrop(corridor().whole(), size), 5);
  print(corridor().whole(), 1);
  Row() << "slowest to fastest"
        << "" << timesOf(largest(raw), quantile(raw, 0)) << ""
        << timesOf(largest(consolidated), quantile(consolidated, 0));
});

/** A loop without shared data or memory access: the upper bound of the machine. */
void
sumRoots(unsigned threads)
{
  constexpr std::size_t numbers = 500000000;
  std::vector<std::thread> others;
  const std::size_t part = numbers / threads;
  for (unsigned t = 0; t < threads; ++t)
    others.emplace_back([=] {
      double sum = 0;
      for (std::size_t i = t * part; i < (t + 1) * part; ++i)
        sum += std::sqrt(static_cast<double>(i));
      [[maybe_unused]] const volatile double kept = sum;
    });
  for (std::thread& other : others)
    other.join();
}

/** \param[in] run with a number of threads */
void
printThreads(const std::string& name,
             std::size_t rounds,
             const std::function<void(unsigned threads)>& run)
{
  std::vector<Cost> costs[2];
  for (std::size_t round = 0; round < rounds; ++round)
    for (const unsigned threads : {1U, 2U})
      costs[threads - 1].push_back(measureCost([&] { run(threads); }));
  const Cost one = medianCost(costs[0]), two = medianCost(costs[1]);
  Row() << name << figure(one.cpu, 2) << figure(two.cpu, 2) << figure(one.wall, 2)
        << figure(two.wall, 2) << timesOf(two.cpu, one.cpu)
        << timesOf(one.wall, two.wall);
}

const Section threads_section("threads", [] {
  printHead("what | 1 thread, CPU s | 2 threads, CPU s | 1 thread, wall s | 2 threads, "
            "wall s | CPU of 2 to 1 | speed-up");
  printThreads("bound: square roots", 3, sumRoots);
  bool are_same = true;
  for (const auto& [size, rounds] : {std::pair{1000000, 3}, {5000000, 1}}) {
    const SimulatedCloud cloud =
        makeCrop(corridor().whole(), static_cast<std::size_t>(size));
    std::optional<Triangles> first;
    const auto mesh = [&](unsigned threads) {
      const Triangles found =
          meshRaw(cloud.points(), DeWallRule::Guarded, threads).mesh.triangles;
      are_same = are_same && (!first || *first == found);
      first = found;
    };
    printThreads(cloud.name, static_cast<std::size_t>(rounds), mesh);
    mesh(8);
  }
  std::cout << "\nThe meshes of 1, 2 and 8 threads are "
            << (are_same ? "the same bytes." : "**different**.") << std::endl;
});

} // namespace
} // namespace pcl::acmap::bench
