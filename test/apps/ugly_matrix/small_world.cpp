#include "small_world.h"

#include "run_tool.h"

#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

const TemporaryFolder&
world()
{
  static const TemporaryFolder folder;
  return folder;
}

std::string
made(const std::string& name,
     const std::string& tool,
     std::vector<std::string> arguments)
{
  const std::string path = world().path(name);
  arguments.insert(arguments.end(), {"-o", path});
  runTool(ACMAP_TOOLS_FOLDER "/" + tool, arguments).succeeded();
  return path;
}

} // namespace

const std::string&
hallScene()
{
  static const std::string text = R"(name: hall
rig: {width: 160, height: 120, focal_length: 130, center_x: 79.5, center_y: 59.5,
      baseline_horizontal: -0.1, baseline_vertical: -0.1, disparity_sigma: 0.13}
sensor: {reach: 9, points: 12000}
looks:
  wall: {color: [150, 140, 130], texture: 60}
surfaces:
  - rectangle: {name: back, corner: [-3, -1.5, 4],
                edges: [[7, 0, 0], [0, 2.7, 0]], look: wall}
  - rectangle: {name: left, corner: [-2, -1.5, -2],
                edges: [[0, 0, 6], [0, 2.7, 0]], look: wall}
  - rectangle: {name: floor, corner: [-3, 1.2, -2],
                edges: [[7, 0, 0], [0, 0, 6]], look: wall}
  - box: {name: box, least: [-0.9, 0.2, 0.6], most: [-0.3, 1.2, 1.2], look: wall}
path:
  - line: {from: [0, 0, -1.5], to: [0, 0, -1.2], views: 2}
)";
  return text;
}

const std::string&
hallSession()
{
  static const std::string path =
      made("session",
           "pcl_simulated_rig",
           {"--scene", world().write("hall.yaml", hallScene()), "--patterns", "3"});
  return path;
}

const std::string&
hallObservations()
{
  static const std::string path =
      made("observations",
           "pcl_simulated_rig",
           {"--scene", world().write("hall.yaml", hallScene()), "--clouds"});
  return path;
}

const std::string&
hallMap()
{
  static const std::string path = made(
      "map",
      "pcl_compact_mapping",
      {hallSession(), "--no-pictures", "--poses", hallSession() + "/trajectory.txt"});
  return path;
}

void
give(const TemporaryFolder& folder, const std::string& from, const std::string& name)
{
  const fs::path to = folder.path(name);
  fs::create_directories(to.parent_path());
  fs::copy(from, to, fs::copy_options::recursive);
}

void
replaceIn(const std::string& path, const std::string& text, const std::string& by)
{
  std::string all = contentOf(path);
  const std::size_t at = all.find(text);
  if (at == std::string::npos)
    throw std::runtime_error(path + " has no " + text);
  std::ofstream(path, std::ios::binary) << all.replace(at, text.size(), by);
}

} // namespace pcl::acmap::test
