#include "bench_data.h"
#include "mesh_checker.h"
#include "mesh_peers.h"
#include "one_view.h"
#include "scene_truth.h"

#include <pcl/conversions.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/filters/depth_refinement.h>
#include <pcl/simulation/standard_scenes.h>
#include <pcl/surface/dewall_triangulation.h>
#include <pcl/surface/organized_fast_mesh.h>

#include <map>
#include <optional>
#include <set>

namespace pcl::acmap::bench {
namespace {

/** \brief A mesh of a view in the camera frame. */
struct OneViewMesh {
  test::Points points;
  test::Triangles triangles;
  double seconds = 0; ///< CPU of the calling thread
};

/** \brief Distance between the distinct depths of a view: median difference of their
 * inverses, 1/m. */
double
inverseDepthStep(const OneView& view)
{
  std::set<float> depths;
  for (const PointXYZ& point : *view.finite.points)
    depths.insert(point.z);
  std::vector<double> steps;
  double before = 0;
  for (const float depth : depths) {
    if (before > 0)
      steps.push_back(1 / before - 1 / static_cast<double>(depth));
    before = depth;
  }
  return median(steps);
}

/** \brief The mesh that the tools make of a view, on one thread. As for \ref ourPlanes,
 * this is the only place to change. */
OneViewMesh
ourMesh(const OneView& view)
{
  OneViewMesh result;
  PointCloud<PointXYZ>::Ptr refined(new PointCloud<PointXYZ>);
  result.seconds = measureThread([&] {
    DepthRefinement<PointXYZ> refinement;
    refinement.setNumberOfThreads(1);
    refinement.setInputCloud(view.organized);
    refinement.filter(*refined);
    DeWallTriangulation<PointXYZ> dewall;
    dewall.setNumberOfThreads(1);
    dewall.setInputCloud(refined);
    TriangleMesh mesh;
    dewall.reconstruct(mesh);
    result.triangles = mesh.triangles;
  });
  result.points = test::toPoints(*refined);
  return result;
}

/** \brief PCL's OrganizedFastMesh with adaptive cut, one triangle per pixel. */
OneViewMesh
organizedMesh(const OneView& view)
{
  OneViewMesh result{test::toPoints(*view.organized), {}};
  std::vector<Vertices> polygons;
  result.seconds = measureThread([&] {
    OrganizedFastMesh<PointXYZ> mesher;
    mesher.setTriangulationType(OrganizedFastMesh<PointXYZ>::TRIANGLE_ADAPTIVE_CUT);
    mesher.setTrianglePixelSize(1);
    mesher.setInputCloud(view.organized);
    mesher.reconstruct(polygons);
  });
  result.triangles = test::toTriangles(polygons);
  return result;
}

/** \brief PCL's greedy projection with its normals: see \ref greedyProjection. */
OneViewMesh
greedyMesh(const OneView& view)
{
  OneViewMesh result{test::toPoints(*view.finite.points), {}};
  const double spacing = test::medianSpacing(result.points);
  result.seconds = measureThread(
      [&] { result.triangles = greedyProjection(*view.finite.points, spacing); });
  return result;
}

/** Number of planes that are not surfaces but quantization levels of the sensor: much
 * flatter than the depth step, perpendicular to the optical axis, and parallel to at least
 * three others. */
std::size_t
countLayers(const OneView& view, const FoundPlanes& found)
{
  constexpr double max_rms = 1.0 / 3.0; // of the depth step
  constexpr std::ptrdiff_t min_parallels = 3;
  const double cosine = std::cos(2 * degree);
  std::vector<std::vector<double>> depths(found.planes.size()), squares = depths;
  for (std::size_t i = 0; i < found.labels.size(); ++i)
    if (found.labels[i] >= 0) {
      const auto f = static_cast<std::size_t>(found.labels[i]);
      const Eigen::Vector3d point =
          (*view.finite.points)[i].getVector3fMap().cast<double>();
      const double off = found.planes[f].head<3>().dot(point) + found.planes[f][3];
      depths[f].push_back(point.z());
      squares[f].push_back(off * off);
    }
  const double inverse_step = inverseDepthStep(view);
  std::size_t layers = 0;
  for (std::size_t f = 0; f < found.planes.size(); ++f) {
    const Eigen::Vector3d normal = found.planes[f].head<3>();
    const double step = inverse_step * std::pow(meanOf(depths[f]), 2);
    const auto parallels = std::count_if(
        found.planes.begin(), found.planes.end(), [&](const Eigen::Vector4d& other) {
          return std::abs(other.head<3>().dot(normal)) >= cosine;
        });
    const bool is_flat = std::sqrt(meanOf(squares[f])) < max_rms * step;
    layers += std::abs(normal.z()) >= cosine && is_flat &&
              parallels > min_parallels; // the plane itself is counted too
  }
  return layers;
}

const Section real_section("real", [] {
  printHead("view | points | finder | planes | layers | points on planes % | CPU s");
  for (const auto& [name, path] :
       {std::pair{"office1", "E_meshing/office1.pcd"},
        {"capture0001", "E_meshing/capture0001.pcd"},
        {"table_scene_mug", "E_meshing/table_scene_mug_stereo_textured.pcd"}})
    if (const auto file = pathOfData(path)) {
      const OneView view = loadOneView(name, *file);
      for (const OneViewFinder& finder : oneViewFinders()) {
        const FoundPlanes found = findInView(finder, view);
        Row() << name << found.labels.size() << finder.name << found.planes.size()
              << countLayers(view, found) << figure(found.labelledPercent(), 1)
              << figure(found.seconds, 3);
      }
    }
});

/** \brief A view of a table: label 0 is the table, the others are boxes. */
struct TableView {
  OneView view;
  std::vector<std::int32_t> labels; ///< of the finite points, -1 for none
  std::size_t boxes = 0;
};

TableView
loadTableView(const std::string& name, const std::string& path)
{
  constexpr std::uint32_t table_label = 1;
  PointCloud<PointXYZL> marked;
  fromPCLPointCloud2(loadPointCloud(path).cloud, marked);
  TableView table{loadOneView(name, path), {}, 0};
  std::map<std::uint32_t, std::int32_t> numbers{{0u, -1}, {table_label, 0}};
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (table.view.finite_of_pixel[i] < 0)
      continue;
    const auto next = static_cast<std::int32_t>(numbers.size()) - 1;
    table.labels.push_back(numbers.emplace(marked[i].label, next).first->second);
  }
  table.boxes = numbers.size() - 2;
  return table;
}

void
printTableRow(const TableView& table, const OneViewFinder& finder)
{
  const FoundPlanes found = findInView(finder, table.view);
  const PlaneOverlaps overlaps(
      table.labels, table.boxes + 1, found.labels, found.planes.size());
  double best = 0; // intersection over union with the table
  std::vector<std::size_t> faces(table.boxes + 1);
  std::size_t on_faces = 0, of_boxes = 0;
  for (std::size_t box = 1; box <= table.boxes; ++box)
    of_boxes += overlaps.truthSize(box);
  for (std::size_t f = 0; f < overlaps.founds(); ++f) {
    const std::size_t common = overlaps.common(f, 0);
    best = std::max(
        best, percent(common, overlaps.truthSize(0) + overlaps.foundSize(f) - common));
    const std::int32_t maximum = overlaps.majority(f);
    if (maximum <= 0)
      continue;
    const auto box = static_cast<std::size_t>(maximum);
    if (2 * overlaps.common(f, box) >= overlaps.foundSize(f)) {
      ++faces[box];
      on_faces += overlaps.common(f, box);
    }
  }
  std::string of_each;
  for (std::size_t box = 1; box <= table.boxes; ++box)
    of_each += (box > 1 ? " + " : "") + std::to_string(faces[box]);
  Row() << table.view.name << table.labels.size() << finder.name << found.planes.size()
        << figure(best, 1) << of_each << figure(percent(on_faces, of_boxes), 1)
        << figure(found.seconds, 3);
}

const Section tables_section("tables", [] {
  printHead("view | points | finder | planes | table: intersection over union % | "
            "faces on each box | points of the boxes on them % | CPU s");
  for (const auto& [name, path] : {std::pair{"mosd learn0", "F_planes/mosd/learn0.pcd"},
                                   {"mosd learn5", "F_planes/mosd/learn5.pcd"}})
    if (const auto found = pathOfData(path)) {
      const TableView table = loadTableView(name, *found);
      for (const OneViewFinder& finder : oneViewFinders())
        printTableRow(table, finder);
    }
});

constexpr std::size_t main_pixels = 2000;      // minimum for a main plane
constexpr MatchLimits found_limits{5.0, 0.05}; // degrees, metres

/** Sums over several views. */
struct ViewScores {
  FoundShare main;          ///< true main planes
  std::size_t spurious = 0; ///< less than half of the points from one true plane
  std::size_t astray = 0;   ///< from one true plane, but with a large deviation
  std::size_t duplicates = 0;
  std::vector<double> angles, offsets; ///< degrees, metres, of main planes found
  std::vector<double> labels, seconds; ///< of each view; percent

  void
  add(const TrueView& seen, const FoundPlanes& result)
  {
    const PlaneCase plane_case{seen.view.name, seen.view.finite, seen.truth};
    const PlaneOverlaps overlaps(seen.truth.labels,
                                 seen.truth.planes.size(),
                                 result.labels,
                                 result.planes.size());
    const PlaneMatches matches =
        matchPlanes(plane_case, result, overlaps, found_limits);
    for (std::size_t t = 0; t < seen.truth.planes.size(); ++t) {
      if (overlaps.truthSize(t) < main_pixels)
        continue;
      main += {matches.finder[t] < 0 ? 0U : 1U, 1};
      if (matches.finder[t] < 0)
        continue;
      angles.push_back(matches.deviation[t].angle);
      offsets.push_back(matches.deviation[t].offset);
    }
    spurious += matches.spurious - matches.astray;
    astray += matches.astray;
    duplicates += matches.duplicates;
    labels.push_back(scoreSegments(overlaps, main_pixels).labels);
    seconds.push_back(result.seconds);
  }

  void
  print(const std::string& scene, const std::string& finder) const
  {
    Row() << scene << finder << main.text() << spurious << astray << duplicates
          << figure(median(angles), 2) << figure(largest(angles), 2)
          << figure(milli * median(offsets), 1) << figure(milli * largest(offsets), 1)
          << figure(meanOf(labels), 1) << figure(meanOf(seconds), 3);
  }
};

/** Ten views each of three scenes. */
void
printSimulated(const std::vector<OneViewFinder>& finders,
               const std::function<void(SimulatedScene&)>& set_sensor)
{
  printHead("views | finder | main planes found | spurious | too far off | duplicates "
            "| angle, median ° | largest | offset, median mm | largest | labels right "
            "% | CPU s a view");
  std::vector<ViewScores> of_all(finders.size());
  for (const char* const name : {"office", "corridor", "loop"}) {
    std::vector<ViewScores> of_scene(finders.size());
    SimulatedScene scene = standardScene(name);
    set_sensor(scene);
    for (std::size_t view = 0; view < 10; ++view) {
      const TrueView seen = makeTrueView(scene, view);
      for (std::size_t f = 0; f < finders.size(); ++f) {
        const FoundPlanes found = finders[f].find(seen.view);
        of_scene[f].add(seen, found);
        of_all[f].add(seen, found);
      }
    }
    for (std::size_t f = 0; f < finders.size(); ++f)
      of_scene[f].print(name, finders[f].name);
  }
  for (std::size_t f = 0; f < finders.size(); ++f)
    of_all[f].print("all 30", finders[f].name);
}

const Section simulated_section("simulated", [] {
  std::vector<OneViewFinder> finders;
  for (const OneViewFinder& finder : oneViewFinders())
    if (!finder.is_slow)
      finders.push_back(finder);
  printSimulated(finders, useKinect);
});

/** The noise of triangulation, without the bounds of the scenes. */
void
useEvenNoise(SimulatedScene& scene)
{
  useAllPixels(scene);
  scene.sensor.min_noise = 0.0001;
  scene.sensor.max_noise = 1;
}

const Section stereo_section("stereo", [] {
  std::vector<OneViewFinder> finders = pictureFinders();
  finders.push_back({"acmap in the picture", [](const OneView& view) {
                       return ourPlanes(view, DepthSensor::Stereo);
                     }});
  printSimulated(finders, useAllPixels);
  printSimulated(finders, useEvenNoise);
});

// At larger distances the noise of a Kinect exceeds the tolerance.
constexpr double truth_reach = 4.0; // metres
constexpr double tolerance = 0.1;   // metres, three standard deviations there

struct NamedMesher {
  const char* name;
  OneViewMesh (*mesh)(const OneView&);
};

constexpr NamedMesher meshers[] = {{"acmap", ourMesh},
                                   {"PCL organized fast mesh", organizedMesh},
                                   {"PCL greedy projection", greedyMesh}};

/** \param[in] truth may be null */
void
printMeshes(const OneView& view,
            const SceneTruth* truth,
            const Eigen::Isometry3d& T_scene_camera)
{
  for (const NamedMesher& mesher : meshers) {
    OneViewMesh mesh = mesher.mesh(view);
    const test::MeshCounts counts = test::countMesh(mesh.points, mesh.triangles);
    double cover = no_reach;
    if (truth) {
      for (Eigen::Vector3d& point : mesh.points)
        point = T_scene_camera * point;
      cover = measureMesh(*truth, mesh.points, mesh.triangles, 2 * tolerance).cover;
    }
    Row() << view.name << view.finite.points->size() << mesher.name
          << mesh.triangles.size()
          << figure(percent(counts.boundary_edges, counts.edges), 2) << figure(cover, 1)
          << figure(mesh.seconds, 2);
  }
}

const Section meshes_section("meshes", [] {
  printHead("view | points | mesher | triangles | boundary edges % | cover % | CPU s");
  for (const auto& [name, path] : {std::pair{"office1", "E_meshing/office1.pcd"},
                                   {"capture0001", "E_meshing/capture0001.pcd"}})
    if (const std::optional<std::string> found = pathOfData(path))
      printMeshes(loadOneView(name, *found), nullptr, Eigen::Isometry3d::Identity());
  for (const char* const name : {"office", "corridor", "loop"}) {
    SimulatedScene scene = standardScene(name);
    useKinect(scene);
    scene.sensor.reach = truth_reach;
    SceneTruth truth(scene);
    truth.see(scene, 0, 4);
    printMeshes(makeTrueView(scene, 0).view, &truth, scene.views[0]);
  }
});

} // namespace
} // namespace pcl::acmap::bench
