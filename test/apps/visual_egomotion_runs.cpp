#include "visual_egomotion_runs.h"

#include "temporary_folder.h"

#include <pcl/core/point_cloud_writer.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>

namespace pcl::acmap::test {

namespace {

namespace fs = std::filesystem;

constexpr const char* scene = R"(name: hall
rig: {width: 160, height: 120, focal_length: 130, center_x: 79.5, center_y: 59.5,
      baseline_horizontal: -0.1, baseline_vertical: -0.1, disparity_sigma: 0.13}
sensor: {reach: 9}
looks:
  wall: {color: [150, 140, 130], texture: 60}
surfaces:
  - rectangle: {name: back, corner: [-3, -1.5, 4],
                edges: [[7, 0, 0], [0, 2.7, 0]], look: wall}
  - rectangle: {name: left, corner: [-2, -1.5, -2],
                edges: [[0, 0, 6], [0, 2.7, 0]], look: wall}
  - rectangle: {name: right, corner: [2, -1.5, -2],
                edges: [[0, 0, 6], [0, 2.7, 0]], look: wall}
  - rectangle: {name: floor, corner: [-3, 1.2, -2],
                edges: [[7, 0, 0], [0, 0, 6]], look: wall}
path:
)";

const PCLPointField&
fieldOf(const PCLPointCloud2& cloud, const std::string& name)
{
  return *std::find_if(cloud.fields.begin(),
                       cloud.fields.end(),
                       [&](const auto& field) { return field.name == name; });
}

void
fillFields(PCLPointCloud2& cloud, const std::vector<std::string>& names, float value)
{
  for (const std::string& name : names)
    for (std::size_t at = fieldOf(cloud, name).offset; at < cloud.data.size();
         at += cloud.point_step)
      std::memcpy(&cloud.data[at], &value, sizeof value);
}

} // namespace

ToolRun
runEgomotion(const std::vector<std::string>& arguments, const RunSettings& settings)
{
  return runTool(ACMAP_VISUAL_EGOMOTION, arguments, settings);
}

Hall
walk(const TemporaryFolder& folder, const std::string& line)
{
  const std::string session = folder.path("session");
  const std::string file =
      folder.write("hall.yaml", scene + ("  - line: " + line + "\n"));
  const ToolRun rig =
      runTool(ACMAP_SIMULATED_RIG, {"-o", session, "--scene", file, "--clouds"});
  EXPECT_EQ(rig.exit_code, 0) << rig.err;
  return {session, loadTrajectory(session + "/trajectory.txt")};
}

const Hall&
hall()
{
  static const TemporaryFolder folder;
  static const Hall made = walk(folder,
                                "{from: [0, 0, 0], to: [0.2, 0, 1.2], views: 6, "
                                "yaw: [0, 4, 8, 4, 0, -4]}");
  return made;
}

std::string
copyOfHall(const std::string& folder)
{
  fs::copy(hall().session, folder);
  return folder;
}

std::string
observationIn(const std::string& folder, std::size_t i)
{
  return folder + "/observation_000" + std::to_string(i) + ".pcd";
}

void
change(const std::string& pcd, const std::function<void(PCLPointCloud2&)>& edit)
{
  PointCloudFile file = loadPointCloud(pcd);
  edit(file.cloud);
  savePointCloud(pcd, file.cloud, file.sensor_origin, file.sensor_orientation);
}

void
blacken(PCLPointCloud2& cloud)
{
  fillFields(cloud, {"rgb"}, 0);
}

void
takePlaces(PCLPointCloud2& cloud)
{
  fillFields(cloud, {"x", "y", "z"}, std::numeric_limits<float>::quiet_NaN());
}

void
turn(PCLPointCloud2& cloud, const Eigen::AngleAxisf& by)
{
  const std::size_t x = fieldOf(cloud, "x").offset; // y and z follow
  for (std::size_t at = x; at < cloud.data.size(); at += cloud.point_step) {
    Eigen::Vector3f place;
    std::memcpy(place.data(), &cloud.data[at], sizeof place);
    place = by * place;
    std::memcpy(&cloud.data[at], place.data(), sizeof place);
  }
}

void
dropField(PCLPointCloud2& cloud, const std::string& name)
{
  cloud.fields.erase(cloud.fields.begin() +
                     (&fieldOf(cloud, name) - cloud.fields.data()));
}

std::set<std::string>
filesIn(const std::string& folder)
{
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

} // namespace pcl::acmap::test
