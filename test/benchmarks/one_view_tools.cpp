#include "bench_data.h"
#include "one_view.h"
#include "processes.h"
#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/core/point_cloud_writer.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>

#include <filesystem>

namespace pcl::acmap::bench {
namespace {

constexpr std::size_t rounds = 6;

/** CPU seconds of a program. */
double
toolSeconds(const std::string& program, const std::vector<std::string>& arguments)
{
  const double begin = childSeconds();
  test::runTool(program, arguments).succeeded();
  return childSeconds() - begin;
}

/** Keeps the least of some times: other load of the machine only adds to them. */
class LeastSeconds {
public:
  void
  add(double seconds)
  {
    least_ = std::min(least_, seconds);
  }

  double
  operator()() const
  {
    return least_;
  }

private:
  double least_ = std::numeric_limits<double>::infinity();
};

/** A view as a file, for tools, and in memory, for PCL's classes. */
struct ViewFile {
  std::string path;
  OneView view;
  double reach; ///< target of the time of planes, in times of PCL's
};

std::vector<ViewFile>
kinectViews()
{
  std::vector<ViewFile> files;
  for (const auto& [name, path] : {std::pair{"office1", "E_meshing/office1.pcd"},
                                   {"capture0001", "E_meshing/capture0001.pcd"}})
    if (const auto file = pathOfData(path))
      files.push_back({*file, loadOneView(name, *file), 0.6});
  return files;
}

/** Views of the office as `pcl_simulated_rig --scene office --clouds --all-points` writes
 * them. */
std::vector<ViewFile>
stereoViews(const test::TemporaryFolder& folder)
{
  std::vector<ViewFile> files;
  SimulatedScene scene = standardScene("office");
  useAllPixels(scene);
  for (const std::size_t view : {0, 10, 20}) {
    const std::string name = "stereo office " + std::to_string(view);
    const std::string path = folder.path(name + ".pcd");
    savePointCloud(path, cloudOf(observe(scene, view, 1)));
    files.push_back({path, loadOneView(name, path), 1.0});
  }
  return files;
}

const Section planes_section("planes", [] {
  printHead("view | points | pcl_plane_extraction, CPU s without its start | start | "
            "PCL organized multi-plane with its normals, CPU s | ratio");
  const test::TemporaryFolder folder;
  std::vector<ViewFile> files = stereoViews(folder);
  for (ViewFile& file : kinectViews())
    files.push_back(std::move(file));
  for (const ViewFile& file : files) {
    LeastSeconds whole, start, peer;
    for (std::size_t round = 0; round < rounds; ++round) {
      whole.add(toolSeconds(
          ACMAP_PLANE_EXTRACTION,
          {file.path, folder.path("planes.json"), "--threads", "1", "--quiet"}));
      start.add(toolSeconds(ACMAP_PLANE_EXTRACTION, {"--version"}));
      peer.add(measureThread([&] { segmentOrganized(file.view); }));
    }
    const double ours = whole() - start();
    Row() << file.view.name << file.view.finite.points->size() << figure(ours, 3)
          << figure(start(), 3) << figure(peer(), 3)
          << atMost(ours / peer(), file.reach, 2);
  }
});

const Section surface_section("surface", [] {
  constexpr std::size_t fewer_rounds = 3; // PCL's tools take seconds
  constexpr double reach = 12;
  printHead("view | points | pcl_dewall_surface, CPU s | pcl_normal_estimation, then "
            "pcl_gp3_surface | ratio");
  const test::TemporaryFolder folder;
  for (const ViewFile& file : kinectViews()) {
    LeastSeconds ours, peer;
    for (std::size_t round = 0; round < fewer_rounds; ++round) {
      ours.add(toolSeconds(
          ACMAP_DEWALL_SURFACE,
          {file.path, folder.path("mesh.vtk"), "--threads", "1", "--quiet"}));
      const std::string normals = folder.path("normals.pcd");
      const std::string mesh = folder.path("peer.vtk");
      peer.add(toolSeconds("pcl_normal_estimation", {file.path, normals, "-k", "16"}) +
               toolSeconds("pcl_gp3_surface",
                           {normals, mesh, "-radius", "0.05", "-mu", "2.5"}));
    }
    Row() << file.view.name << file.view.finite.points->size() << figure(ours(), 2)
          << figure(peer(), 2) << atLeast(peer() / ours(), reach, 1);
  }
});

} // namespace
} // namespace pcl::acmap::bench
