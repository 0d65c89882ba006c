#include "active_stereo_runs.h"
#include "json_file.h"

#include <pcl/stereo/trinocular_matching.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

using ActiveStereoLists = ActiveStereoRuns;

/** One image per camera. */
class ActiveStereoPair : public ActiveStereoRuns {
protected:
  ActiveStereoPair()
  {
    for (auto& list : images_)
      list.resize(1);
  }

  /** Runs the tool with a report, which it returns. */
  nlohmann::json
  reportOf(std::vector<std::string> more)
  {
    const std::string report = folder_.path("report.json");
    more.insert(more.end(), {"--report", report});
    const ToolRun run = runLists(more);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return jsonOfFile(report);
  }

  /** What TrinocularMatching finds by its defaults within the range of a report. */
  DisparityImage
  matchedByClass(const nlohmann::json& report, std::int32_t pattern) const
  {
    TrinocularFrame frame;
    frame.pattern = pattern;
    for (std::size_t i = 0; i < images_.size(); ++i)
      frame.images[i] = loadCameraImage(images_[i][0]);
    TrinocularMatching matching;
    matching.setInputRig(loadTrinocularRig(rig_));
    const int minimum = report["least_disparity"], maximum = report["most_disparity"];
    matching.setXOffset(minimum);
    matching.setMaxDisparity(maximum - minimum + 1);
    MatchedDisparity matched;
    matching.match(frame, matched);
    return matched.disparity;
  }

  /** Checks the written disparities. */
  void
  expectWritten(const DisparityImage& wanted) const
  {
    const DisparityImage written = loadPfm(out("disparity.pfm"));
    ASSERT_EQ(written.values.size(), wanted.values.size());
    for (std::size_t i = 0; i < wanted.values.size(); ++i)
      if (std::isfinite(wanted.values[i]))
        ASSERT_EQ(written.values[i], wanted.values[i]) << i;
      else
        ASSERT_FALSE(std::isfinite(written.values[i])) << i;
  }
};

void
expectGood(const TruthFit& fit, double min_found)
{
  EXPECT_GT(fit.found, min_found);
  EXPECT_LT(fit.wrong, 0.02);
  EXPECT_LT(fit.median, 0.1);
}

TEST_F(ActiveStereoLists, MakeOneObservationAndItsDisparities)
{
  const ToolRun run = runLists().succeeded();
  EXPECT_THAT(run.out, HasSubstr("observations: 1\n"));
  const DisparityImage disparity = loadPfm(out("disparity.pfm"));
  expectGood(fitOf(disparity, session()), 0.85);
  EXPECT_EQ(loadGrayImage16(out("disparity.png")).height, 120);
  const StereoCloud lists = loadStereo(out("observation_0000.pcd")).cloud;

  // the session's points, except for the colours from the shot without a pattern
  std::filesystem::remove_all(out_);
  runSession().succeeded();
  const StereoCloud cloud = loadStereo(out("observation_0000.pcd")).cloud;
  ASSERT_EQ(cloud.size(), lists.size());
  std::size_t colored = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (std::isfinite(cloud[i].z)) {
      ASSERT_EQ(lists[i].getVector3fMap(), cloud[i].getVector3fMap()) << i;
    }
    else {
      ASSERT_TRUE(std::isnan(lists[i].z)) << i;
    }
    colored += lists[i].rgba != cloud[i].rgba ? 1 : 0;
  }
  EXPECT_GT(colored, cloud.size() / 2);
}

TEST_F(ActiveStereoLists, ColoursMayComeFromAnImage)
{
  const std::string off = filmed_->path("off.png");
  runLists({"--color", off}).succeeded();
  const RgbImage image = loadRgbImage(off);
  const StereoCloud cloud = loadStereo(out("observation_0000.pcd")).cloud;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ASSERT_EQ(cloud[i].r, image.values[3 * i]) << i;
    ASSERT_EQ(cloud[i].b, image.values[3 * i + 2]) << i;
  }
}

TEST_F(ActiveStereoLists, TwoViewsAreEnough)
{
  const auto fit = [&] {
    const ToolRun run = runLists();
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const DisparityImage disparity = loadPfm(out("disparity.pfm"));
    std::filesystem::remove_all(out_);
    return fitOf(disparity, session());
  };
  const auto all = images_;
  images_[2].clear();
  expectGood(fit(), 0.75);
  images_ = all;
  images_[1].clear(); // both baselines have the same length
  expectGood(fit(), 0.75);
}

TEST_F(ActiveStereoPair, OnePatternWillDo)
{
  const auto report = reportOf({"--active"});
  EXPECT_EQ(report["method"], "spacetime");
  EXPECT_EQ(report["observations"][0]["shots"], 1);
  expectGood(fitOf(loadPfm(out("disparity.pfm")), session()), 0.85);
  expectWritten(matchedByClass(report, 0));
}

TEST_F(ActiveStereoPair, IsMatchedPassivelyByTheDefaultsOfTheClass)
{
  const auto report = reportOf({});
  EXPECT_EQ(report["method"], "passive");
  EXPECT_EQ(report["observations"][0]["shots"], 0);
  EXPECT_EQ(report["observations"][0]["off_shots"], 1);
  const DisparityImage passive = matchedByClass(report, TrinocularFrame::no_pattern);
  EXPECT_NE(passive.values, matchedByClass(report, 0).values);
  expectWritten(passive);
}

TEST_F(ActiveStereoPair, SummaryTellsHowItWasMatched)
{
  const ToolRun passive = runLists();
  EXPECT_THAT(passive.out,
              HasSubstr("passive stereo, one image per camera (--active: taken under "
                        "a pattern)\n"));
  EXPECT_EQ(passive.err, "");
  std::filesystem::remove_all(out_);
  const ToolRun active = runLists({"--active"});
  EXPECT_THAT(active.out, HasSubstr("one shot under a pattern (--active)\n"));
  EXPECT_THAT(active.err, HasSubstr("patterns' light"));
}

TEST_F(ActiveStereoPair, HasTheColoursOfTheReference)
{
  runLists().succeeded();
  const RgbImage image = loadRgbImage(images_[0][0]);
  const StereoCloud cloud = loadStereo(out("observation_0000.pcd")).cloud;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ASSERT_EQ(cloud[i].r, image.values[3 * i]) << i;
    ASSERT_EQ(cloud[i].b, image.values[3 * i + 2]) << i;
  }
}

TEST_F(ActiveStereoPair, MayHaveColoursOfItsOwnUnderAPattern)
{
  const std::string off = filmed_->path("off.png");
  const auto report = reportOf({"--active", "--color", off});
  EXPECT_EQ(report["observations"][0]["off_shots"], 1);
  expectWritten(matchedByClass(report, 0));
  EXPECT_EQ(loadStereo(out("observation_0000.pcd")).cloud[0].r,
            loadRgbImage(off).values[0]);
}

TEST_F(ActiveStereoPair, ThresholdsReachTheMatcher)
{
  const auto matched = [&](const std::vector<std::string>& more) {
    const auto outcomes = reportOf(more)["outcomes"];
    std::filesystem::remove_all(out_);
    return outcomes;
  };
  const auto plain = matched({});
  EXPECT_EQ(plain["uncorrelated"], 0);
  EXPECT_GT(matched({"--min-texture", "20"})["untextured"], plain["untextured"]);
  EXPECT_GT(matched({"--min-correlation", "0.9"})["uncorrelated"], 0);
  const auto active = matched({"--active"});
  EXPECT_GT(matched({"--active", "--min-texture", "20"})["untextured"],
            active["untextured"]);
  EXPECT_GT(matched({"--active", "--min-correlation", "0.9"})["uncorrelated"],
            active["uncorrelated"]);
}

TEST_F(ActiveStereoLists, DepthsThatNoImageReachesAreNotPromised)
{
  // 160 columns: the maximum disparity is 159 px
  const ToolRun run = runLists({"--min-depth", "0.01"}).succeeded();
  EXPECT_THAT(run.out, HasSubstr("0 to 159 px, depths of 0.0818 to 10 m"));
  std::filesystem::remove_all(out_);
  expectRefused(runLists({"--min-depth", "0.01", "--max-depth", "0.05"}),
                2,
                "--max-depth: at 0.05 m ");
}

TEST_F(ActiveStereoLists, AllMethodsFindTheTruth)
{
  std::vector<std::string> found;
  for (const char* method : {"median", "statistical", "spacetime"}) {
    const ToolRun run = runLists({"--method", method}).succeeded();
    EXPECT_THAT(run.out, HasSubstr(method));
    expectGood(fitOf(loadPfm(out("disparity.pfm")), session()), 0.85);
    found.push_back(contentOf(out("disparity.pfm")));
    std::filesystem::remove_all(out_);
  }
  EXPECT_NE(found[0], found[1]);
  EXPECT_NE(found[1], found[2]);
}

TEST_F(ActiveStereoLists, DepthsBoundSearchAndPoints)
{
  const std::string report = folder_.path("report.json");
  runLists({"--min-depth", "1.2", "--max-depth", "2", "--report", report}).succeeded();
  const auto json = jsonOfFile(report);
  EXPECT_EQ(json["least_disparity"], 5); // 6.5 px at 2 m, minus one pixel, rounded down
  EXPECT_EQ(json["most_disparity"], 12); // 10.8 px at 1.2 m, rounded up, plus one pixel
  for (const PointXYZRGBSigma& point : loadStereo(out("observation_0000.pcd")).cloud)
    if (std::isfinite(point.z)) {
      ASSERT_GE(point.z, 1.2f);
      ASSERT_LE(point.z, 2.0f);
    }
}

TEST_F(ActiveStereoLists, ThresholdsReachTheMatcher)
{
  const auto matched = [&](const std::vector<std::string>& more) {
    const std::string report = folder_.path("report.json");
    std::vector<std::string> all = joined({"--report", report}, more);
    EXPECT_EQ(runLists(all).exit_code, 0);
    std::filesystem::remove_all(out_);
    return jsonOfFile(report)["outcomes"];
  };
  const auto plain = matched({});
  EXPECT_GT(matched({"--min-texture", "20"})["untextured"], plain["untextured"]);
  EXPECT_GT(matched({"--min-correlation", "0.99"})["uncorrelated"],
            plain["uncorrelated"]);
}

} // namespace
} // namespace pcl::acmap::test
