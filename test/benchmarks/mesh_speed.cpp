#include "bench.h"
#include "clouds.h"
#include "mesh_peers.h"
#include "meshes.h"
#include "processes.h"
#include "scene_truth.h"
#include "simulated_clouds.h"
#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/simulation/standard_scenes.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
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
  for (const DeWallRule rule : {DeWallRule::Paper, DeWallRule::Dense}) {
    const MapRun run = runInChild([&] { return meshMap(rule); });
    const auto points = static_cast<double>(run.points);
    const auto peak = static_cast<double>(run.peak);
    Row() << ruleName(rule) << run.points << run.triangles << figure(run.seconds, 1)
          << figure(1e6 * run.seconds / points, 2)
          << figure(percent(run.used_points, run.points), 1) << figure(peak / points, 0)
          << figure(1e-9 * peak, 2);
  }
});

/** A view as a PCL cloud, with its truth if there is one. */
struct SpeedView {
  std::string name;
  test::Cloud cloud;
  const SceneTruth* truth = nullptr;
  Eigen::Isometry3d T_scene_cloud = Eigen::Isometry3d::Identity();

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
  for (const DeWallRule rule : {DeWallRule::Paper, DeWallRule::Dense})
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
  if (!view.truth) {
    row << no_value << no_value << no_value;
    return;
  }
  for (Eigen::Vector3d& place : places)
    place = view.T_scene_cloud * place;
  const MeshFigures figures = measureMesh(*view.truth, places, mesh, 2 * tolerance);
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
  const SceneTruth truth = corridor().truthOfView(0);
  printView({first.name, *plainPoints(first), &truth, first.T_scene_cloud});
  printView({"simulated corridor view", test::makeCorridorView(138654, 1)});
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
                          [&] { meshRaw(cloud.points(), DeWallRule::Paper); }),
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

const Section consolidated_section("consolidated", [] {
  constexpr std::size_t rounds = 5;
  const SimulatedCloud& cloud = corridor().whole();
  std::vector<double> consolidations, meshes, sums;
  std::size_t representatives = 0, triangles = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    ConsolidationReport report;
    Consolidation consolidation;
    consolidations.push_back(
        measureThread([&] { consolidation = consolidate(cloud, voxel, report); }));
    meshes.push_back(measureThread(
        [&] { triangles = meshOf(consolidation, voxel).triangles.size(); }));
    sums.push_back(consolidations.back() + meshes.back());
    representatives = consolidation.representatives.size();
  }
  printHead("points | representatives | triangles | consolidation, CPU s | mesh, CPU s "
            "| sum, CPU s | CPU us a point");
  Row() << cloud.size() << representatives << triangles
        << figure(median(consolidations), 2) << figure(median(meshes), 2)
        << figure(median(sums), 2)
        << figure(1e6 * median(sums) / static_cast<double>(cloud.size()), 3);
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
          meshRaw(cloud.points(), DeWallRule::Paper, threads).mesh.triangles;
      are_same = are_same && (!first || *first == found);
      first = found;
    };
    printThreads(cloud.name, static_cast<std::size_t>(rounds), mesh);
    mesh(8);
  }
  std::cout << "\nThe meshes of 1, 2 and 8 threads are "
            << (are_same ? "the same bytes." : "**different**.") << std::endl;
});

using Action = std::function<void()>;
using PlainFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

PlainFile
openPlain(const std::string& path, const char* mode)
{
  PlainFile file(std::fopen(path.c_str(), mode), std::fclose);
  if (!file)
    throw std::runtime_error("cannot open " + path);
  return file;
}

void
readPlain(const std::string& path)
{
  const std::size_t bytes = std::filesystem::file_size(path);
  const std::unique_ptr<char[]> data(new char[bytes]); // not initialized
  if (std::fread(data.get(), 1, bytes, openPlain(path, "rb").get()) != bytes)
    throw std::runtime_error("short read");
}

void
writePlain(const std::string& path, const std::vector<char>& data)
{
  if (std::fwrite(data.data(), 1, data.size(), openPlain(path, "wb").get()) !=
      data.size())
    throw std::runtime_error("short write");
}

/** A file whose rows are printed. */
struct TimedFile {
  std::string path;
  std::size_t points;

  /** Prints a row; both methods are timed in interleaved rounds. */
  void
  print(const std::string& name, const Action& ours, const Action& plain) const
  {
    constexpr std::size_t rounds = 5;
    std::vector<Cost> our_costs, plain_costs;
    for (std::size_t round = 0; round < rounds; ++round) {
      our_costs.push_back(measureCost(ours));
      plain_costs.push_back(measureCost(plain));
    }
    const Cost our = medianCost(our_costs), bound = medianCost(plain_costs);
    const double each = 1e9 / static_cast<double>(points);
    Row() << name << points
          << figure(1e-6 * static_cast<double>(std::filesystem::file_size(path)), 1)
          << figure(each * our.wall, 1) << figure(each * bound.wall, 1)
          << timesOf(our.wall, bound.wall) << figure(each * our.cpu, 1)
          << timesOf(our.cpu, bound.cpu);
  }

  void
  printLoad(const std::string& name, const Action& load) const
  {
    print("load " + name, load, [&] { readPlain(path); });
  }

  void
  printLoad(const std::string& name) const
  {
    printLoad(name, [&] { loadPointCloud(path); });
  }

  /** Saves once to get the size, then prints the row. */
  void
  printSave(const std::string& name, const Action& save) const
  {
    save();
    const std::vector<char> bytes(std::filesystem::file_size(path), 'x');
    print("save " + name, save, [&] { writePlain(path + ".plain", bytes); });
    std::filesystem::remove(path + ".plain");
  }
};

/** A square grid with two triangles per cell. */
void
makeGridMesh(std::int32_t cells, PCLPointCloud2& cloud, TriangleMesh& mesh)
{
  PointCloud<PointXYZ> points;
  for (std::int32_t row = 0; row <= cells; ++row)
    for (std::int32_t column = 0; column <= cells; ++column) {
      points.emplace_back(static_cast<float>(column), static_cast<float>(row), 0.0F);
      if (row == cells || column == cells)
        continue;
      const std::int32_t corner = row * (cells + 1) + column;
      const std::int32_t above = corner + cells + 1;
      mesh.triangles.push_back({corner, corner + 1, above});
      mesh.triangles.push_back({corner + 1, above + 1, above});
    }
  toPCLPointCloud2(points, cloud);
}

const Section files_section("files", [] {
  printHead("what | points | file, MB | wall ns a point | plain fread or fwrite | "
            "takes | CPU ns a point | takes, CPU");
  const test::TemporaryFolder folder;
  const PCLPointCloud2 cloud = cloudOf(makeCrop(corridor().whole(), 5000000).merged);
  const std::size_t points = std::size_t{cloud.width} * cloud.height;
  const TimedFile pcd{folder.path("cloud.pcd"), points};
  pcd.printSave("PCD", [&] { savePointCloud(pcd.path, cloud); });
  pcd.printLoad("PCD");
  const TimedFile ply{folder.path("cloud.ply"), points};
  saveTriangleMesh(ply.path, cloud, TriangleMesh());
  ply.printLoad("PLY cloud");
  PCLPointCloud2 corners;
  TriangleMesh mesh;
  makeGridMesh(1000, corners, mesh);
  const TimedFile file{folder.path("mesh.ply"),
                       std::size_t{corners.width} * corners.height};
  file.printSave("PLY mesh, two faces a point",
                 [&] { saveTriangleMesh(file.path, corners, mesh); });
  file.printLoad("points of the PLY mesh");
  file.printLoad("faces of the PLY mesh", [&] { loadTriangleMesh(file.path); });
});

} // namespace
} // namespace pcl::acmap::bench
