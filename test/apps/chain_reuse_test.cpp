#include "chain_runs.h"
#include "plane_runs.h"
#include "tool_cases.h"
#include "virtual_display.h"

#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

using Stages = std::vector<std::string>;

const Stages all_stages = {"observations", "egomotion", "rectification", "map"};

class ChainReuse : public ChainTest {
protected:
  void
  SetUp() override
  {
    ChainTest::SetUp();
    first_ = resultsIn(map_);
  }

  /** \brief Runs again, and returns the stages that were not reused. */
  Stages
  made(const std::vector<std::string>& options = {}) const
  {
    const ToolRun run = runAgain(options);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return madeStages(map_);
  }

  std::string
  stageFile(const std::string& stage) const
  {
    return map_ + "/stages/" + stage + "/stage.json";
  }

  std::map<std::string, std::string> first_; ///< results of the first run
};

TEST_F(ChainReuse, NothingIsMadeTwice)
{
  EXPECT_THAT(made(), IsEmpty());
  EXPECT_EQ(stagesOf(map_), all_stages);
  EXPECT_THAT(differing(resultsIn(map_), first_), IsEmpty());
  EXPECT_THAT(made({"--threads", "1", "--quiet"}), IsEmpty());
}

TEST_F(ChainReuse, TheStageWhoseOptionChangedIsMadeAgainAndThoseAfterIt)
{
  EXPECT_EQ(made({"--texel", "0.03"}), Stages{"map"});
  EXPECT_NE(contentOf(map_ + "/map.glb"), first_.at("map.glb"));
  EXPECT_THAT(made({"--texel", "0.03"}), IsEmpty());
  EXPECT_THAT(made({"--bin", "0.06"}), ElementsAre("rectification", "map"));
  EXPECT_THAT(made({"--keypoints", "900"}),
              ElementsAre("egomotion", "rectification", "map"));
  EXPECT_EQ(made({"--max-depth", "8"}), all_stages);
}

TEST_F(ChainReuse, SixDegreesOfFreedomAddAStage)
{
  EXPECT_THAT(made({"--6dof"}),
              ElementsAre("egomotion", "rectification", "adjustment", "map"));
  EXPECT_THAT(made({"--6dof"}), IsEmpty());
  EXPECT_THAT(made({"--6dof", "--texel", "0.03"}), ElementsAre("map"));
}

TEST_F(ChainReuse, AChangedFrameChangesAll)
{
  const fs::path frame = session_ + "/frame_000000.acf";
  fs::last_write_time(frame, fs::last_write_time(frame) + std::chrono::seconds(1));
  EXPECT_EQ(made(), all_stages);
  EXPECT_THAT(differing(resultsIn(map_), first_), IsEmpty());
}

TEST_F(ChainReuse, AMissingObservationIsMadeAgain)
{
  fs::remove(map_ + "/stages/observations/observation_0001.pcd");
  EXPECT_EQ(made(), all_stages);
  EXPECT_THAT(differing(resultsIn(map_), first_), IsEmpty());
}

TEST_F(ChainReuse, ASpoiltMapIsMadeAgain)
{
  fs::remove(map_ + "/map.obj");
  EXPECT_EQ(made(), Stages{"map"});
  EXPECT_THAT(differing(resultsIn(map_), first_), IsEmpty());
}

TEST_F(ChainReuse, DamagedNotesOfAStageCostThatStage)
{
  const std::string whole = contentOf(stageFile("map"));
  auto other = jsonOfFile(stageFile("map"));
  other["made_of"]["version"] = "0.0.0";
  for (const std::string& damaged :
       {whole.substr(0, whole.size() / 2), other.dump(), std::string("[]")}) {
    std::ofstream(stageFile("map"), std::ios::binary) << damaged;
    EXPECT_EQ(made(), Stages{"map"}) << damaged.substr(0, 400);
  }
  EXPECT_THAT(differing(resultsIn(map_), first_), IsEmpty());
}

TEST_F(ChainReuse, WhatTheNewMapHasNotIsRemoved)
{
  std::ofstream(map_ + "/mine.txt") << "mine";
  EXPECT_EQ(made({"--no-rectification"}), Stages{"map"});
  for (const char* name :
       {"trajectory_before.txt", "pictures/energy.png", "pictures/plan.png"})
    EXPECT_FALSE(fs::exists(map_ + "/" + name)) << name;
  EXPECT_TRUE(fs::exists(map_ + "/map.json"));
  EXPECT_EQ(contentOf(map_ + "/mine.txt"), "mine");
  EXPECT_EQ(stagesOf(map_), (Stages{"observations", "egomotion", "map"}));
  // the rectification is still stored
  EXPECT_EQ(made(), Stages{"map"});
  first_["mine.txt"] = "mine";
  EXPECT_THAT(differing(resultsIn(map_), first_), IsEmpty());
}

TEST_F(ChainReuse, PicturesStayWithTheirMapAndGoWithIt)
{
  const VirtualDisplay& display = VirtualDisplay::shared();
  if (!display.exists())
    GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
  // as in the first run, but with pictures
  const std::vector<std::string> command = {session_, "-o", map_, "--min-depth", "1"};
  runTool(ACMAP_COMPACT_MAPPING, command).succeeded();
  EXPECT_EQ(madeStages(map_), Stages{"map"});
  const auto with_pictures = resultsIn(map_);
  const char* const pictures[] = {"pictures/inside.png",
                                  "pictures/outside.png",
                                  "pictures/floor_plan.png",
                                  "pictures/planes.png",
                                  "pictures/mesh.png"};
  for (const char* name : pictures)
    EXPECT_EQ(with_pictures.count(name), 1U) << name;

  EXPECT_THAT(made(), IsEmpty()) << "the same map, now with --no-pictures";
  EXPECT_THAT(differing(resultsIn(map_), with_pictures), IsEmpty());
  EXPECT_THAT(contentOf(map_ + "/report.html"), HasSubstr("The map from inside"));

  const ToolRun other = runAgain({"--texel", "0.03"}).succeeded();
  const std::size_t line = other.out.find("removed:");
  ASSERT_NE(line, std::string::npos) << other.out;
  for (const char* name : pictures) {
    EXPECT_FALSE(fs::exists(map_ + "/" + name)) << name;
    EXPECT_NE(other.out.find(name, line), std::string::npos) << other.out;
  }
  EXPECT_TRUE(fs::exists(map_ + "/pictures/plan.png"))
      << "of the rectification, still the same";
}

TEST_F(ChainReuse, WhatSomebodyChangedSinceIsNotRemoved)
{
  std::ofstream(map_ + "/pictures/energy.png") << "mine";
  EXPECT_EQ(made({"--no-rectification"}), Stages{"map"});
  EXPECT_EQ(contentOf(map_ + "/pictures/energy.png"), "mine");
}

TEST_F(ChainReuse, FilesOfTheUserAmongStagesAreNotDeleted)
{
  const std::string mine = map_ + "/stages/observations/mine.txt";
  std::ofstream(mine) << "mine";
  EXPECT_THAT(made(), IsEmpty());
  expectRefused(runAgain({"--max-depth", "8"}), 5, "mine.txt");
  fs::remove(stageFile("observations"));
  expectRefused(runAgain(), 5, "stages/observations");
  EXPECT_THAT(resultsIn(map_), Contains(Pair("stages/observations/mine.txt", "mine")));
  fs::remove(mine);
  first_.erase("stages/observations/mine.txt");
  EXPECT_THAT(differing(resultsIn(map_), first_), IsEmpty());
}

TEST_F(ChainReuse, AFolderOrFileInTheWayIsRefused)
{
  const std::string out = folder_.path("out");
  fs::create_directories(out + "/stages/observations/mine");
  expectRefused(runSessionChain(session_, out), 5, "mine");
  EXPECT_TRUE(fs::exists(out + "/stages/observations/mine"));
  fs::remove_all(out + "/stages");
  std::ofstream(out + "/stages") << "mine";
  expectRefused(runSessionChain(session_, out), 5, "stages");
  EXPECT_EQ(contentOf(out + "/stages"), "mine");
}

} // namespace
} // namespace pcl::acmap::test
