#include "every_tool.h"

#include "rendered_boards.h"
#include "rgbd_folders.h"
#include "virtual_display.h"

#include <pcl/core/image_file.h>

#include <array>
#include <cstdlib>
#include <set>
#include <stdexcept>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

// Images of a board that are enough for a calibration, and about the smallest ones in
// which the boards are found.
constexpr std::size_t shot_count = 6;
constexpr double board_scale = 0.65;

/** \brief The smallest building that gives a map. */
constexpr const char* scene = R"(name: corridor_bit
rig: {width: 224, height: 168, focal_length: 179, center_x: 111.5, center_y: 83.5,
      baseline_horizontal: -0.1, baseline_vertical: -0.1, disparity_sigma: 0.13}
sensor: {reach: 6, points: 1500}
building: corridor
path:
  - line: {from: [0, 0, 0.05], to: [0, 0, 0.65], views: 3, yaw: [0, 3, 0]}
)";

constexpr const char* figures = R"(scene: corridor_bit
observations: 3
width: 200
fig2: {observation: 0, patterns: [0, 1, 2], from: [-1, -1, -1], look: [0, 0, 3]}
fig3: [{observation: 2, from: [-1, -1, -1], look: [0, 0, 3]}]
fig4: {cut: 1.1, views: [{from: [-8, -8, -4], look: [0, 0, 4]}]}
fig5: {observation: 1, steps: 3, from: [-1, -1, -1], look: [0, 0, 3]}
fig7: {observation: 1, from: [-1, -1, -1], look: [0, 0, 3]}
fig8: {from: [0, 0, 0.5], look: [0, 0, 5]}
fig9: {from: [-8, -8, -4], look: [0, 0, 4]}
fig10: {from: [8, -8, 10], look: [0, 0, 3]}
)";

void
writeBoards(const TemporaryFolder& folder)
{
  const std::vector<TrinocularFrame> shots =
      boardShots(builtRig(board_scale), shot_count);
  for (std::size_t shot = 0; shot < shots.size(); ++shot)
    for (std::size_t i = 0; i < 3; ++i) {
      const CameraImage& image = shots[shot].images[i];
      folder.write(shotNames(shot)[i],
                   textOfBytes(encodePng(image.width, image.height, image.values)));
    }
}

class Inputs {
public:
  Inputs()
  {
    folder_.write("scene.yaml", scene);
    folder_.write("figures.yaml", figures);
    const std::string session = folder_.path("session");
    const std::string map = folder_.path("map");
    const std::string posed = folder_.path("posed");
    runTool(ACMAP_TOOLS "/pcl_simulated_rig",
            {"-o", session, "--scene", folder_.path("scene.yaml"), "--patterns", "3"})
        .succeeded();
    runTool(ACMAP_TOOLS "/pcl_compact_mapping",
            {session, "-o", map, "--min-depth", "1", "--no-pictures"})
        .succeeded();
    fs::copy(map + "/stages/observations", posed);
    fs::remove(posed + "/stage.json");
    fs::copy(map + "/trajectory.txt", posed);
    fs::copy(posed + "/observation_0000.pcd", folder_.path("cloud.pcd"));
    writeBoards(folder_);
    writeSevenScenes(rgbd_, 3);
    fs::copy(rgbd_.path(""), folder_.path("rgbd"));
  }

  const TemporaryFolder&
  folder() const
  {
    return folder_;
  }

private:
  TemporaryFolder folder_;
  TemporaryFolder rgbd_;
};

/** \brief Arguments of pcl_compact_mapping for one of the \ref Inputs. */
ToolRow
rowOfChain(const std::string& input)
{
  return {"pcl_compact_mapping",
          {"<" + input, "-o", ">map", "--min-depth", "1", "--no-pictures"},
          "stages"};
}

/** \brief Arguments of a tool that opens a recording like a camera. */
ToolRow
rowOfGrabber(const std::string& tool)
{
  return {tool,
          {"--device",
           "<session",
           "--pcd",
           ">clouds",
           "-o",
           ">recorded",
           "--min-depth",
           "1"},
          "clouds and session"};
}

std::vector<ToolRow>
rows()
{
  std::vector<std::string> boards = {"-o", ">rig.yaml", "--square", "0.03"};
  const std::array<const char*, 3> cameras = {
      "--reference", "--horizontal", "--vertical"};
  for (std::size_t i = 0; i < 3; ++i) {
    boards.emplace_back(cameras[i]);
    for (std::size_t shot = 0; shot < shot_count; ++shot)
      boards.push_back("<" + shotNames(shot)[i]);
  }
  const std::string planes = "<map/map.json";
  return {
      {"pcl_active_stereo",
       {"<session", "-o", ">observations", "--min-depth", "1", "--disparity"},
       "observations"},
      rowOfGrabber("pcl_camera_grabber"),
      rowOfChain("session"),
      {"pcl_cloud_info", {"<cloud.pcd"}},
      {"pcl_compact_viewer", {"<map", "--screenshot", ">picture.png"}, "", true},
      {"pcl_dewall_surface", {"<cloud.pcd", ">mesh.ply", "--consolidate"}},
      {"pcl_dewall_surface", {"<cloud.pcd", ">mesh.vtk", "--consolidate"}},
      rowOfGrabber("pcl_digiclops_grabber"),
      {"pcl_entropy_rectification", {"<posed", "-o", ">rectified"}},
      {"pcl_line_pattern", {">patterns", "--patterns", "4"}},
      {"pcl_line_pattern", {">pattern.png"}},
      {"acmap_paper_figures",
       {"<session", "<map", "-o", ">figures", "--figures", "<figures.yaml"},
       "",
       true,
       true},
      {"pcl_plane_extraction",
       {"<map/mesh.ply",
        ">planes.json",
        "--labels",
        ">labels.pcd",
        "--normals",
        ">normals.ply",
        "--picture",
        ">picture.png"},
       "",
       true},
      {"pcl_plane_texturing", {planes, "<posed", "-o", ">map"}},
      {"pcl_rgbd_import", {"<rgbd", "-o", ">observations"}},
      {"pcl_rig_calibration", boards},
      {"pcl_simulated_rig",
       {"--scene", "<scene.yaml", "-o", ">session", "--patterns", "2"}},
      {"pcl_simulated_rig",
       {"--scene", "<scene.yaml", "-o", ">clouds", "--clouds", "--merged", ">all.pcd"}},
      {"pcl_visual_egomotion", {"<posed", "-o", ">posed"}},
  };
}

} // namespace

const std::vector<ToolRow>&
everyTool()
{
  static const std::vector<ToolRow> all = [] {
    std::vector<ToolRow> with_report = rows();
    for (ToolRow& row : with_report)
      row.arguments.insert(row.arguments.end(), {"--report", ">report.json"});
    return with_report;
  }();
  return all;
}

const TemporaryFolder&
smallInputs()
{
  static const Inputs inputs;
  return inputs.folder();
}

ToolRun
runRow(const ToolRow& row,
       const std::function<std::string(const std::string& output)>& place,
       const RunSettings& settings)
{
  std::vector<std::string> arguments;
  for (const std::string& argument : row.arguments)
    if (argument.front() == '<')
      arguments.push_back(smallInputs().path(argument.substr(1)));
    else
      arguments.push_back(argument.front() == '>' ? place(argument.substr(1))
                                                  : argument);
  return runTool(ACMAP_TOOLS "/" + row.tool, arguments, settings);
}

std::vector<std::string>
outputsOf(const ToolRow& row)
{
  std::vector<std::string> names;
  for (const std::string& argument : row.arguments)
    if (argument.front() == '>')
      names.push_back(argument.substr(1));
  return names;
}

bool
canRun(const ToolRow& row)
{
  static const VirtualDisplay display;
  return !row.needs_screen || display.exists();
}

std::optional<int>
wantedMoments()
{
  const char* const text = std::getenv("ACMAP_MOMENTS");
  return text ? std::optional(std::atoi(text)) : std::nullopt;
}

bool
isWorthwhile(const ToolRow& row)
{
  return canRun(row) && (!row.is_slow || wantedMoments());
}

std::map<std::string, std::string>
resultsBelow(const std::string& folder)
{
  const std::set<std::string> of_the_run = {
      "report.json", "report.html", "stage.json", "finished.json"};
  std::map<std::string, std::string> results;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() &&
        of_the_run.count(entry.path().filename().string()) == 0)
      results[fs::relative(entry.path(), folder).string()] =
          contentOf(entry.path().string());
  return results;
}

std::vector<std::string>
hiddenBelow(const std::string& folder)
{
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename().string().front() == '.')
      paths.push_back(entry.path().string());
  return paths;
}

} // namespace pcl::acmap::test
