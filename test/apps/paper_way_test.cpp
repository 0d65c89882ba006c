#include "chain_runs.h"
#include "plane_runs.h"

#include <pcl/pipeline/compact_mapping.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/texture/compact_map_folder.h>

#include <gmock/gmock.h>

#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

/** With fewer points, the paper's planes do not take long. */
const std::vector<std::string> thin = {"--max-points", "20000"};

std::vector<std::string>
with(std::vector<std::string> options, const std::vector<std::string>& more)
{
  options.insert(options.end(), more.begin(), more.end());
  return options;
}

/** The report of a stage. */
nlohmann::json
stageOf(const std::string& map, std::size_t number)
{
  return jsonOfFile(map + "/report.json").at("stages").at(number).at("details");
}

/** The session of ChainTest and its map by the paper's way. */
class PaperWay : public ChainTest {
protected:
  void
  SetUp() override
  {
    ChainTest::SetUp();
    paper_ = folder_.path("paper");
    runSessionChain(session_, paper_, with(thin, {"--paper"})).succeeded();
  }

  std::string paper_;
};

TEST_F(PaperWay, MakesTheMapOfTheClass)
{
  const ObservationSequence sequence(observationPaths(paper_ + "/stages/observations"));
  CompactMapping mapping;
  mapping.setMode(MappingMode::Paper);
  ObservationMerging merging = mapping.getMerging();
  merging.setMaximumPoints(20000);
  mapping.setMerging(merging);
  mapping.setInputSequence(sequence, false);
  CompactMap map;
  mapping.compute(map);
  const TemporaryFolder folder;
  for (const std::string& name : saveCompactMap(folder.path(""), map))
    EXPECT_EQ(contentOf(folder.path(name)), contentOf(paper_ + "/" + name)) << name;

  const std::string median = folder_.path("median");
  runTool(ACMAP_ACTIVE_STEREO,
          {session_, "-o", median, "--method", "median", "--min-depth", "1"})
      .succeeded();
  for (const char* name :
       {"observation_0000.pcd", "observation_0001.pcd", "observation_0002.pcd"})
    EXPECT_EQ(contentOf(median + "/" + name),
              contentOf(paper_ + "/stages/observations/" + name));
}

TEST_F(PaperWay, TellsWhatRan)
{
  const auto report = jsonOfFile(paper_ + "/report.json");
  EXPECT_EQ(report.at("mode"), "paper");
  EXPECT_EQ(jsonOfFile(map_ + "/report.json").at("mode"), "accurate");
  EXPECT_EQ(stageOf(paper_, 0).at("method"), "median");
  const auto egomotion = stageOf(paper_, 1);
  EXPECT_EQ(egomotion.at("mode"), "paper");
  EXPECT_EQ(egomotion.at("fits"), egomotion.at("pairs").size());
  for (const auto& pair : egomotion.at("pairs")) {
    EXPECT_EQ(pair.at("fits"), 1);
    EXPECT_EQ(pair.at("is_refined"), false);
  }
  const auto rectification = stageOf(paper_, 2);
  EXPECT_EQ(rectification.at("mode"), "paper");
  EXPECT_GT(rectification.at("votes"), 0);
  EXPECT_EQ(rectification.at("consolidated_points"), 0);
  const auto map = stageOf(paper_, 3);
  EXPECT_EQ(map.at("mode"), "paper");
  EXPECT_EQ(map.at("consolidated_points"), 0);
  EXPECT_FALSE(map.contains("consolidation"));
  EXPECT_GT(map.at("mesh").at("walls"), 0);
  EXPECT_GT(stageOf(map_, 3).at("consolidated_points"), 0);
  EXPECT_EQ(stageOf(map_, 1).at("mode"), "accurate");
}

TEST_F(PaperWay, IsMadeAnewInTheFolderOfAnotherMap)
{
  runAgain(with(thin, {"--paper"})).succeeded();
  EXPECT_THAT(madeStages(map_),
              ElementsAre("observations", "egomotion", "rectification", "map"));
  EXPECT_EQ(contentOf(map_ + "/map.json"), contentOf(paper_ + "/map.json"));
}

TEST_F(ChainTest, WhatDepartsFromThePaperIsRefusedWithIt)
{
  for (const std::vector<std::string>& departure :
       {std::vector<std::string>{"--method", "spacetime"},
        {"--6dof"},
        {"--max-translation", "2"},
        {"--max-rotation", "10"},
        {"--keypoints", "100"},
        {"--mode", "guarded"},
        {"--odometry-noise", "0.01", "0.1"},
        {"--consolidate"},
        {"--min-area", "0.2"},
        {"--tolerance", "0.02"},
        {"--regular"},
        {"--sensor", "stereo"},
        {"--max-distance", "0.1"},
        {"--fill", "2"}}) {
    const ToolRun run =
        runChain(session_, folder_.path("refused"), with({"--paper"}, departure));
    EXPECT_EQ(run.exit_code, 2) << departure[0];
    EXPECT_THAT(run.err, HasSubstr(departure[0]));
    EXPECT_THAT(run.err, HasSubstr("--paper"));
  }
  EXPECT_FALSE(fs::exists(folder_.path("refused")));
}

TEST_F(ChainTest, ShotsWithoutProjectedLightGoToTheEnd)
{
  const std::string unlit = folder_.path("unlit");
  const ToolRun run = runSessionChain(session_, unlit, {"--unlit"});
  ASSERT_TRUE(run.exit_code == 0 || run.exit_code == 4) << run.err;
  const std::string made = folder_.path("made");
  ASSERT_EQ(runTool(ACMAP_ACTIVE_STEREO,
                    {session_, "-o", made, "--unlit", "--min-depth", "1"})
                .exit_code,
            0);
  for (const char* name : {"/observation_0000.pcd", "/observation_0002.pcd"})
    EXPECT_EQ(contentOf(made + name), contentOf(unlit + "/stages/observations" + name));
  if (run.exit_code == 0) {
    EXPECT_EQ(stageOf(unlit, 0).at("method"), "passive");
  }
  EXPECT_EQ(
      runSessionChain(session_, unlit, {"--unlit", "--method", "median"}).exit_code, 2);
}

} // namespace
} // namespace pcl::acmap::test
