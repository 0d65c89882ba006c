#include "json_file.h"
#include "run_tool.h"
#include "simulated_runs.h"
#include "temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** A wall that fills the view. */
constexpr const char* wall = R"(name: wall
rig: {width: 64, height: 48, focal_length: 52, center_x: 31.5, center_y: 23.5,
      baseline_horizontal: -0.1, baseline_vertical: -0.1, disparity_sigma: 0.13}
looks:
  wall: {color: [150, 140, 130], texture: 0}
surfaces:
  - rectangle: {name: wall, corner: [-9, 9, 2], edges: [[18, 0, 0], [0, -18, 0]], look: wall}
path:
  - line: {from: [0, 0, 0], to: [0, 0, 1], views: 1}
)";

/** \brief The shots of the reference camera, without and with a pattern. */
struct Shots {
  CameraImage off;
  CameraImage on;
};

class SimulatedLightOptions : public testing::Test {
protected:
  ToolRun
  film(const std::vector<std::string>& more) const
  {
    return runTool(
        ACMAP_SIMULATED_RIG,
        joined({"-o", session_, "--scene", folder_.write("wall.yaml", wall)}, more));
  }

  /** \brief Films without noise and blur, unless the options set them. */
  Shots
  shots(const std::vector<std::string>& more) const
  {
    std::vector<std::string> all = {
        "--patterns", "1", "--read-noise", "0", "--shot-noise", "0", "--blur", "0"};
    for (std::size_t i = 0; i < more.size(); i += 2) {
      const auto known = std::find(all.begin(), all.end(), more[i]);
      if (known != all.end())
        all.erase(known, known + 2);
    }
    all.insert(all.end(), more.begin(), more.end());
    std::filesystem::remove_all(session_);
    const ToolRun run = film(all);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const auto frames = framesOf(session_);
    if (frames.size() != 2)
      throw std::runtime_error("not two frames");
    return {frames[0]->images[0], frames[1]->images[0]};
  }

  TemporaryFolder folder_;
  std::string session_ = folder_.path("session");
};

double
varianceOf(const CameraImage& image, std::size_t channel)
{
  double sum = 0;
  double squares = 0;
  double count = 0;
  for (std::size_t i = channel; i < image.values.size(); i += 3) {
    const double value = image.values[i];
    sum += value;
    squares += value * value;
    ++count;
  }
  return squares / count - sum * sum / count / count;
}

TEST_F(SimulatedLightOptions, LightIsAsAsked)
{
  const Shots usual = shots({});
  EXPECT_NEAR(meanOf(usual.off), 0.45 * 140, 0.5);
  EXPECT_NEAR(meanOf(shots({"--ambient", "0.2"}).off), 0.2 * 140, 0.5);
  EXPECT_NEAR(meanOf(shots({"--exposure", "2"}).off), 2 * 0.45 * 140, 0.5);
  EXPECT_GT(meanOf(usual.on), meanOf(usual.off) + 5);
  const Shots dark = shots({"--projector-power", "0"});
  EXPECT_TRUE(dark.on == dark.off);
  EXPECT_NEAR(meanOf(shots({"--projector-power", "2"}).on) - meanOf(usual.off),
              2 * (meanOf(usual.on) - meanOf(usual.off)),
              1.0);
}

TEST_F(SimulatedLightOptions, FaultsAreAsAsked)
{
  const Shots usual = shots({});
  EXPECT_EQ(varianceOf(usual.off, 0), 0.0);
  EXPECT_NEAR(varianceOf(shots({"--read-noise", "3"}).off, 0), 9.0, 1.0);
  EXPECT_NEAR(varianceOf(shots({"--shot-noise", "0.2"}).off, 0), 0.2 * 0.45 * 150, 2.0);
  EXPECT_LT(varianceOf(shots({"--blur", "2"}).on, 0), 0.7 * varianceOf(usual.on, 0));
  const CameraImage rim = shots({"--vignetting"}).off;
  const std::size_t middle = 3 * (24 * 64 + 32);
  EXPECT_NEAR(rim.values[middle], usual.off.values[middle], 1);
  EXPECT_LT(rim.values[0], 0.7 * usual.off.values[0]);
}

TEST_F(SimulatedLightOptions, TruthTellsWhatWasUsed)
{
  shots({"--ambient",
         "0.25",
         "--projector-power",
         "0.75",
         "--exposure",
         "1.5",
         "--read-noise",
         "2",
         "--shot-noise",
         "0.125",
         "--blur",
         "0.375"});
  auto truth = jsonOfFile(session_ + "/truth.json");
  EXPECT_EQ(truth["light"],
            nlohmann::json(
                R"({"ambient": 0.25, "projector_power": 0.75, "aperture": 640,
              "exposure": 1.5, "blur": 0.375, "vignetting": false})"_json));
  EXPECT_EQ(truth["noise"], R"({"read": 2, "shot": 0.125})"_json);
  shots({"--vignetting"});
  truth = jsonOfFile(session_ + "/truth.json");
  EXPECT_EQ(truth["light"]["vignetting"], true);
}

TEST_F(SimulatedLightOptions, NonsenseIsRefused)
{
  const auto refused = [&](const std::vector<std::string>& options,
                           const std::vector<std::string>& words) {
    const ToolRun run = film(options);
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_EQ(run.errorLines(), 1u) << run.err;
    for (const std::string& word : words)
      EXPECT_THAT(run.err, HasSubstr(word));
    EXPECT_FALSE(std::filesystem::exists(session_));
  };
  for (const char* value : {"-0.1", "1e9", "nan", "inf"}) {
    refused({"--ambient", value}, {"ambient", "[0, 1e+06] of full colour"});
    refused({"--projector-power", value}, {"projector power", "[0, 1e+06] of ambient"});
    refused({"--exposure", value}, {"exposure", "[0, 1e+06] (a factor)"});
    refused({"--read-noise", value}, {"read_noise", "[0, 255] grey levels"});
    refused({"--shot-noise", value}, {"shot_noise", "[0, 255] grey levels"});
    refused({"--blur", value}, {"blur", "[0, 20] px"});
  }
  refused({"--blur", "much"}, {"--blur", "much"});
  refused({"--exposure"}, {"--exposure"});
  for (const char* name : {"--ambient",
                           "--projector-power",
                           "--exposure",
                           "--read-noise",
                           "--shot-noise",
                           "--blur",
                           "--patterns",
                           "--cameras"})
    refused({"--clouds", name, "1"}, {name, "--clouds makes none"});
  refused({"--clouds", "--vignetting"}, {"--vignetting", "--clouds makes none"});
}

} // namespace
} // namespace pcl::acmap::test
