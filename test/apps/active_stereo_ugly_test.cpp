#include "active_stereo_runs.h"

#include <pcl/core/rig_calibration.h>

#include <gmock/gmock.h>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

using ActiveStereoUgly = ActiveStereoRuns;

std::string
pngOf(std::int32_t width, std::int32_t height, std::uint8_t grey)
{
  const std::vector<std::uint8_t> bytes = encodePng(
      width, height, std::vector<std::uint8_t>(std::size_t(width * height), grey));
  return {bytes.begin(), bytes.end()};
}

TEST_F(ActiveStereoUgly, HelpTellsUnitsAndDefaults)
{
  const ToolRun help = runTool(ACMAP_ACTIVE_STEREO, {"--help"}).succeeded();
  for (const char* word : {"SESSION_DIR",
                           "--min-depth M ",
                           " 0.5]",
                           "--max-depth M ",
                           " 10]",
                           "metres",
                           "grey levels",
                           "--method NAME ",
                           "PNG, JPEG, PGM or PPM",
                           "--rectify",
                           "--active",
                           "--threads",
                           "Exit codes"})
    EXPECT_THAT(help.out, HasSubstr(word));
  EXPECT_THAT(runTool(ACMAP_ACTIVE_STEREO, {"--version"}).out,
              HasSubstr(ACMAP_VERSION));
}

TEST_F(ActiveStereoUgly, OptionsThatMakeNoSenseAreRefused)
{
  const auto refused = [&](const std::vector<std::string>& arguments,
                           const char* word) {
    expectRefused(runTool(ACMAP_ACTIVE_STEREO, arguments), 2, word);
  };
  refused({"-o", out_}, "--reference");
  refused({input_}, "--output");
  refused({input_, "-o", out_, "--reference", images_[0][0]}, "not both");
  refused({input_, "-o", out_, "--rig", rig_}, "--reference");
  refused({input_, "-o", out_, "--method", "mean"}, "--method");
  refused({input_, "-o", out_, "--min-depth", "-1"}, "--min-depth");
  refused({input_, "-o", out_, "--min-depth", "3", "--max-depth", "3"}, "not below");
  refused({input_, "-o", out_, "--max-depth", "nan"}, "--max-depth");
  refused({input_, "-o", out_, "--min-correlation", "2"}, "--min-correlation");
  refused({"-o", out_, "--reference", images_[0][0], "--horizontal", images_[1][0]},
          "--rig");
  refused({"-o", out_, "--rig", rig_, "--reference", images_[0][0]}, "--vertical");
  refused({"-o", out_, "--reference", "--rig", rig_}, "images are missing");
  expectRefused(runLists({"--poses", session() + "/trajectory.txt"}), 2, "--poses");
  refused({input_, "-o", out_, "--poses", ""}, "--poses");
  images_[2].pop_back();
  expectRefused(runLists(), 2, "vertical camera: 5 images, 6 are needed");
  images_[2].push_back(images_[1][0]);
  expectRefused(runLists(), 2, "was there before");
}

TEST_F(ActiveStereoUgly, OptionsWithoutEffectAreRefused)
{
  expectRefused(runSession({"--active"}), 2, "--active");
  expectRefused(runLists({"--active"}), 2, "--active is for one image per camera");
  for (auto& list : images_)
    list.resize(1);
  const std::string off = filmed_->path("off.png");
  for (const char* method : {"spacetime", "median", "statistical"}) {
    expectRefused(runLists({"--method", method}), 2, "nothing to fuse");
    expectRefused(runLists({"--method", method, "--active"}), 2, "nothing to fuse");
  }
  expectRefused(runLists({"--color", off}), 2, "--color is for shots under patterns");
}

TEST_F(ActiveStereoUgly, OneImagePerCameraIsCheckedAsMany)
{
  for (auto& list : images_)
    list.resize(1);
  const std::string small = folder_.write("small.png", pngOf(80, 60, 90));
  for (const std::size_t camera : {0u, 1u, 2u})
    for (const std::vector<std::string>& more :
         {std::vector<std::string>(), std::vector<std::string>{"--active"}}) {
      const std::string before = std::exchange(images_[camera][0], small);
      expectRefused(runLists(more), 3, "small.png");
      images_[camera][0] = folder_.path("none.png");
      expectRefused(runLists(more), 3, "none.png");
      images_[camera][0] = before;
    }
  images_[1].push_back(images_[2][0]);
  expectRefused(runLists(), 2, "horizontal camera: 2 images, 1 are needed");
  images_[1] = images_[0];
  expectRefused(runLists(), 2, "was there before");
  for (std::size_t camera = 0; camera < 3; ++camera)
    images_[camera] = {
        folder_.write(std::to_string(camera) + ".png", pngOf(160, 120, 90))};
  expectRefused(runLists(), 4, "untextured");
}

TEST_F(ActiveStereoUgly, ImagesThatCannotBeReadAreNamed)
{
  const auto refused = [&](const std::string& path, const char* word) {
    for (const std::size_t camera : {0u, 1u, 2u}) {
      const std::string before = std::exchange(images_[camera][3], path);
      expectRefused(runLists(), 3, word);
      images_[camera][3] = before;
    }
  };
  refused(folder_.path("none.png"), "none.png");
  refused(folder_.write("empty.png", ""), "empty.png");
  const std::string whole = contentOf(images_[0][0]);
  refused(folder_.write("cut.png", whole.substr(0, whole.size() / 2)), "cut.png");
  refused(folder_.write("small.png", pngOf(80, 60, 90)), "small.png");
  refused(folder_.path("."), folder_.path(".").c_str());
  expectRefused(runLists({"--color", folder_.path("small.png")}), 3, "small.png");
  expectRefused(runLists({"--color", folder_.path("none.png")}), 3, "none.png");
}

TEST_F(ActiveStereoUgly, RigsThatDoNotServeAreRefused)
{
  const auto refused = [&](const std::string& rig, const char* word) {
    rig_ = rig;
    expectRefused(runLists(), 3, word);
  };
  const std::string text = contentOf(rig_);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    other.replace(other.find(from), from.size(), to);
    return folder_.write("changed.yaml", other);
  };
  refused(folder_.path("none.yaml"), "none.yaml");
  refused(folder_.write("empty.yaml", ""), "empty.yaml");
  refused(changed("focal_length: 130", "focal_length: .nan"), "changed.yaml");
  refused(changed("width: 160", "width: 320"), "320");
  rig_ = session() + "/rig.yaml";
  expectRefused(runLists({"--rectify"}), 3, "camera_reference");
  for (const std::string name : {"vertical", "horizontal"}) {
    rig_ = changed("baseline_" + name + ": -0.1", "baseline_" + name + ": 0");
    expectRefused(runLists(), 2, "--" + name + ": " + rig_ + " has no " + name);
  }
}

TEST_F(ActiveStereoUgly, MoreThanAnyMemoryIsRefused)
{
  expectRefused(
      runLists({"--memory-limit", "1MB"}), 6, "disparities of 160 x 120 pixels");
}

TEST_F(ActiveStereoUgly, SessionsThatAreNoneAreRefused)
{
  input_ = folder_.path("none");
  std::filesystem::create_directory(input_);
  expectRefused(runSession(), 3, "rig.yaml");
  std::filesystem::copy_file(rig_, input_ + "/rig.yaml");
  expectRefused(runSession(), 3, "no frame");
  TrinocularRig alone = loadTrinocularRig(rig_);
  alone.baseline_horizontal = alone.baseline_vertical = 0;
  saveTrinocularRig(input_ + "/rig.yaml", alone);
  expectRefused(runSession(), 3, "no neighbour");
}

TEST_F(ActiveStereoUgly, WhereNothingMatchesNothingIsWritten)
{
  const std::string grey = pngOf(160, 120, 90);
  for (std::size_t camera = 0; camera < 3; ++camera)
    for (std::size_t shot = 0; shot < images_[camera].size(); ++shot)
      images_[camera][shot] = folder_.write(
          std::to_string(camera) + "-" + std::to_string(shot) + ".png", grey);
  expectRefused(runLists(), 4, "untextured");
}

TEST_F(ActiveStereoUgly, PlacesThatAreTakenStay)
{
  std::filesystem::create_directory(out_);
  const auto refused = [&](const char* name) {
    std::ofstream(out(name)) << "mine";
    const ToolRun run = runSession();
    EXPECT_EQ(run.exit_code, 5) << run.err;
    EXPECT_THAT(run.err, HasSubstr(name));
    EXPECT_EQ(contentOf(out(name)), "mine");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(out_), {}), 1);
    std::filesystem::remove(out(name));
  };
  refused("observation_0007.pcd");
  refused("trajectory.txt");
  refused("disparity.pfm");
  std::ofstream(out("notes.txt")) << "mine";
  EXPECT_EQ(runSession().exit_code, 0);
  EXPECT_EQ(contentOf(out("notes.txt")), "mine");
  out_ = folder_.path("no/such");
  expectRefused(runSession(), 5, "no/such");
  std::filesystem::copy(session(), folder_.path("copy"));
  input_ = out_ = folder_.path("copy");
  const ToolRun run = runSession();
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("session's folder"));
}

TEST_F(ActiveStereoUgly, AFullDiskLeavesNothing)
{
  RunSettings full;
  full.file_size_limit = 100000; // an observation has 380 kB
  expectRefused(runSession({}, full), 5, "observation_0000.pcd");
}

} // namespace
} // namespace pcl::acmap::test
