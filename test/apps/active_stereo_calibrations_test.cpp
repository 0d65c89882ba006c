#include "active_stereo_runs.h"
#include "json_file.h"
#include "test_data.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

class ActiveStereoCalibrations : public ActiveStereoRuns {
protected:
  /** \brief Leaves the horizontal pair of the filmed room. */
  void
  useRoom()
  {
    images_[2].clear();
  }

  /** \brief Share of the pixels of a public pair that are matched. */
  double
  matchedShare(const std::vector<std::string>& rig)
  {
    const std::string report = folder_.path("report.json");
    const ToolRun run = runPair(rig, {"--report", report});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    std::filesystem::remove_all(out_);
    return run.exit_code == 0 ? jsonOfFile(report)["matched_share"].get<double>() : 0;
  }

  ToolRun
  runPair(const std::vector<std::string>& rig,
          const std::vector<std::string>& more = {}) const
  {
    std::vector<std::string> all = {"--reference",
                                    testDataPath(pair_ + "left.png").string(),
                                    "--horizontal",
                                    testDataPath(pair_ + "right.png").string(),
                                    "-o",
                                    out_,
                                    "--rig"};
    all.insert(all.end(), rig.begin(), rig.end());
    all.insert(all.end(), more.begin(), more.end());
    return runTool(ACMAP_ACTIVE_STEREO, all);
  }

  const std::string pair_ = "H_field/recordings/stereo_pair/";
};

TEST_F(ActiveStereoCalibrations, WrongSignsAreRefusedByWhatTheImagesShow)
{
  useRoom();
  std::swap(images_[0], images_[1]);
  const ToolRun run = runLists();
  expectRefused(run, 3, "baseline_horizontal = -0.1 m has the wrong sign");
  EXPECT_THAT(run.err, HasSubstr("0.1 m there, or as --baseline"));
  EXPECT_EQ(runLists({"--baseline", "0.1"}).exit_code, 0);
  std::filesystem::remove_all(out_);
  const ToolRun kept = runLists({"--baseline", "-0.1"});
  EXPECT_THAT(kept.err, HasSubstr("wrong sign"));
}

TEST_F(ActiveStereoCalibrations, AMatrixAndABaselineAreEnough)
{
  useRoom();
  const ToolRun by_rig = runLists().succeeded();
  const std::string disparities = contentOf(out("disparity.pfm"));
  std::filesystem::remove_all(out_);
  rig_ = folder_.write("K.txt", "130 0 79.5\n0 130 59.5\n0 0 1\n");
  expectRefused(runLists(), 3, "--baseline");
  const ToolRun by_matrix = runLists({"--baseline", "-0.1"}).succeeded();
  EXPECT_THAT(by_matrix.out, HasSubstr("a camera matrix as text"));
  EXPECT_EQ(contentOf(out("disparity.pfm")), disparities);
}

/** Images that begin two columns farther right have a principal point two less. */
TEST_F(ActiveStereoCalibrations, DepthsAreThoseOfPairsWithAnotherPrincipalPoint)
{
  useRoom();
  runLists().succeeded();
  const StereoCloud wanted = loadStereo(out("observation_0000.pcd")).cloud;
  std::filesystem::remove_all(out_);
  constexpr int shift = 2;
  for (std::string& path : images_[1]) {
    const RgbImage image = loadRgbImage(path);
    RgbImage shifted = image;
    for (int row = 0; row < image.height; ++row)
      for (int column = 0; column + shift < image.width; ++column)
        std::copy_n(image.at(column + shift, row), 3, shifted.at(column, row));
    path = folder_.path(std::filesystem::path(path).filename().string());
    savePng(path, shifted);
  }
  TrinocularRig rig = loadTrinocularRig(rig_);
  rig.baseline_vertical = 0;
  rig.center_x_horizontal = rig.center_x - shift;
  rig_ = folder_.path("verged.yaml");
  saveTrinocularRig(rig_, rig);
  runLists().succeeded();
  const StereoCloud found = loadStereo(out("observation_0000.pcd")).cloud;
  ASSERT_EQ(found.size(), wanted.size());
  std::size_t both = 0;
  std::size_t equal = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (std::isfinite(found[i].z) && std::isfinite(wanted[i].z)) {
      ++both;
      equal += std::abs(found[i].z - wanted[i].z) < 0.05F * wanted[i].z ? 1 : 0;
    }
  EXPECT_GT(both, found.size() / 4);
  EXPECT_GT(equal, both * 9 / 10); // 5 % are a third of a pixel
}

TEST_F(ActiveStereoCalibrations, CalibrationsOfOthersMatchAPublicPair)
{
  if (!hasTestData(pair_ + "K.txt"))
    GTEST_SKIP() << pair_ << " is not in the folder that ACMAP_TEST_DATA names";
  const std::string camera = "  camera_model: pinhole\n"
                             "  distortion_coeffs: [0, 0, 0, 0]\n"
                             "  distortion_model: radtan\n"
                             "  intrinsics: [754.668, 754.668, 489.379, 265.162]\n"
                             "  resolution: [960, 540]\n";
  const std::string matrix = "[754.668, 0, 489.379, 0, 754.668, 265.162, 0, 0, 1]";
  const std::string kalibr =
      folder_.write("camchain.yaml",
                    "cam0:\n" + camera + "cam1:\n" + camera +
                        "  T_cn_cnm1: [[1, 0, 0, -0.063], [0, 1, 0, 0], [0, 0, 1, 0], "
                        "[0, 0, 0, 1]]\n");
  const auto info = [&](const std::string& name, const std::string& offset) {
    return folder_.write(name,
                         "image_width: 960\nimage_height: 540\ncamera_matrix: {rows: "
                         "3, cols: 3, data: " +
                             matrix +
                             "}\ndistortion_model: plumb_bob\nprojection_matrix: "
                             "{rows: 3, cols: 4, data: "
                             "[754.668, 0, 489.379, " +
                             offset + ", 0, 754.668, 265.162, 0, 0, 0, 1, 0]}\n");
  };
  const auto opencv =
      [](const std::string& key, const std::string& shape, const std::string& data) {
        return key + ": !!opencv-matrix\n   " + shape + "\n   dt: d\n   data: " + data +
               "\n";
      };
  const std::string square = "rows: 3\n   cols: 3";
  const std::string stereo = folder_.write(
      "stereo.yml",
      "%YAML:1.0\n---\n" + opencv("K1", square, matrix) + opencv("K2", square, matrix) +
          opencv("R", square, "[1, 0, 0, 0, 1, 0, 0, 0, 1]") +
          opencv("T", "rows: 3\n   cols: 1", "[-0.063, 0, 0]"));
  const std::string text = testDataPath(pair_ + "K.txt").string();
  const std::vector<std::vector<std::string>> rigs = {
      {kalibr},
      {info("left.yaml", "0"), info("right.yaml", "-47.544")},
      {stereo},
      {text}};
  for (const std::vector<std::string>& rig : rigs)
    EXPECT_GT(matchedShare(rig), 0.55) << rig.front();
  expectRefused(
      runPair({testDataPath(pair_ + "rig_wrong_sign.yaml").string()}), 3, "wrong sign");
}

} // namespace
} // namespace pcl::acmap::test
