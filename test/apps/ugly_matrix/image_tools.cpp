#include "case_list.h"
#include "rgbd_folders.h"
#include "small_world.h"
#include "test_png.h"
#include "ugly_tools.h"

#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* color = "kinect/frame-000010.color.png";
constexpr const char* depth = "kinect/frame-000010.depth.png";
constexpr const char* pose = "kinect/frame-000010.pose.txt";

constexpr const char* dark_frame = "a depth image without a depth";
constexpr const char* dark_frames = "all depth images without a depth";
constexpr const char* one_depth = "a depth image of one depth";
constexpr const char* doubled_shot = "a frame that is there twice";
constexpr const char* odd_recording = "Messung Nr. 1/Aufnahme 測量";
constexpr const char* millimetre_poses = "poses in millimetres";
constexpr const char* coarse_depths = "depths in millimetres, read as metres";

std::string
depthsOf(std::uint16_t first, std::uint16_t others)
{
  std::vector<std::uint16_t> values(std::size_t(small_width) * small_height, others);
  values[20] = first;
  return depthPngBytes(small_width, small_height, values);
}

void
writeRecording(const TemporaryFolder& folder)
{
  const TemporaryFolder made;
  writeSevenScenes(made, 3);
  give(folder, made.path(""), "kinect");
}

void
addPoses(CaseList& list, const std::vector<std::string>& command)
{
  list.add(Ugliness::NanOnly, "a pose of NaN", pose, [](const auto& folder) {
    folder.write(pose, "nan 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  });
  list.add(Ugliness::Huge, "a pose at 10³⁰ m", pose, [](const auto& folder) {
    folder.write(pose, "1 0 0 1e30\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  });
  list.add(Ugliness::Millimetres, millimetre_poses, pose, [](const auto& folder) {
    folder.write(pose, "1 0 0 3000\n0 1 0 0\n0 0 1 200\n0 0 0 1\n");
  });
  std::vector<std::string> as_metres = command;
  as_metres.insert(as_metres.end(), {"--depth-scale", "1"});
  list.addRun(Ugliness::Millimetres, coarse_depths, "kinect", as_metres);
}

} // namespace

UglyTool
uglyRgbdImport()
{
  const std::string output = "clouds";
  const auto command = [output](const std::string& input) {
    return std::vector<std::string>{input, "--registered", "-o", output};
  };
  CaseList list(writeRecording,
                command("kinect"),
                {{dark_frame, {0, "have no point at all"}},
                 {millimetre_poses, {0, "are the poses in metres?"}},
                 {coarse_depths, {0, "--depth-scale"}},
                 {"a pose at 10³⁰ m", {3, "frame-000010"}},
                 {dark_frames, {4, "no depth image has a point"}},
                 {one_depth, {0, ""}},
                 {doubled_shot, {0, ""}},
                 {odd_recording, {0, ""}}});
  for (const char* file : {color, depth, pose})
    list.addFile(file);
  list.addRun(Ugliness::Missing, "no such folder", "none", command("none"));
  list.addRun(Ugliness::Folder,
              "a file for the folder",
              "none",
              command("none"),
              [](const auto& folder) { folder.write("none", "x"); });
  list.add(Ugliness::NanOnly, dark_frame, depth, [](const auto& folder) {
    folder.write(depth, depthsOf(0, 0));
  });
  list.add(Ugliness::NanOnly, dark_frames, depth, [](const auto& folder) {
    for (const char* frame : {"00", "10", "20"})
      folder.write(std::string("kinect/frame-0000") + frame + ".depth.png",
                   depthsOf(0, 0));
  });
  addPoses(list, command("kinect"));
  list.add(Ugliness::OnePoint, one_depth, depth, [](const auto& folder) {
    folder.write(depth, depthsOf(1500, 0));
  });
  list.add(Ugliness::Doubled, doubled_shot, "kinect", [](const auto& folder) {
    for (const char* part : {".color.png", ".depth.png", ".pose.txt"})
      fs::copy(folder.path(std::string("kinect/frame-000010") + part),
               folder.path(std::string("kinect/frame-000011") + part));
  });
  list.add(
      Ugliness::WrongFields, "a depth image of colours", depth, [](const auto& folder) {
        fs::copy(folder.path(color),
                 folder.path(depth),
                 fs::copy_options::overwrite_existing);
      });
  list.addRun(
      Ugliness::Names,
      odd_recording,
      odd_recording,
      command(odd_recording),
      [](const auto& folder) { give(folder, folder.path("kinect"), odd_recording); });
  return {"pcl_rgbd_import", output, true, false, list.cases()};
}

} // namespace pcl::acmap::test
