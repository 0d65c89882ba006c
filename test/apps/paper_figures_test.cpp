#include "run_tool.h"
#include "small_session.h"
#include "temporary_folder.h"
#include "virtual_display.h"

#include <pcl/core/image_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::vector<std::string> names = {"fig2.png",
                                        "fig3.png",
                                        "fig4.png",
                                        "fig5.png",
                                        "fig7.png",
                                        "fig8.png",
                                        "fig9.png",
                                        "fig10.png"};

/** Figures of a session with three observations under three patterns. */
const char* const small_figures = R"(scene: corridor_drive
observations: 3
width: 300
fig2: {observation: 0, patterns: [0, 1, 2], from: [-1, -1, -1], look: [0, 0, 3]}
fig3: [{observation: 2, from: [-1, -1, -1], look: [0, 0, 3]}]
fig4: {cut: 1.1, views: [{from: [-8, -8, -4], look: [0, 0, 4]}]}
fig5: {observation: 1, steps: 3, from: [-1, -1, -1], look: [0, 0, 3]}
fig7: {observation: 1, from: [-1, -1, -1], look: [0, 0, 3]}
fig8: {from: [0, 0, 0.5], look: [0, 0, 5]}
fig9: {from: [-8, -8, -4], look: [0, 0, 4]}
fig10: {from: [8, -8, 10], look: [0, 0, 3]}
)";

/** A session and its map, made once for all tests. */
class PaperFigures : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    folder_ = new TemporaryFolder;
    display_ = new VirtualDisplay;
    filmSmallSession(session());
    runTool(ACMAP_COMPACT_MAPPING, {session(), "-o", map(), "--no-pictures"})
        .succeeded();
    folder_->write("small.yaml", small_figures);
  }

  static void
  TearDownTestSuite()
  {
    delete display_;
    delete folder_;
  }

  void
  SetUp() override
  {
    if (!display_->exists())
      GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
  }

  static std::string
  session()
  {
    return folder_->path("session");
  }

  static std::string
  map()
  {
    return folder_->path("map");
  }

  /** A copy of the map, which a test may modify. */
  static std::string
  copyOfMap(const TemporaryFolder& folder)
  {
    fs::copy(map(), folder.path("map"), fs::copy_options::recursive);
    return folder.path("map");
  }

  static std::vector<std::string>
  arguments(const std::string& of_session,
            const std::string& of_map,
            const std::string& output,
            const std::string& figures = folder_->path("small.yaml"))
  {
    return {of_session, of_map, "-o", output, "--figures", figures};
  }

  static void
  expectRefused(const std::vector<std::string>& all,
                int exit_code,
                const std::string& word)
  {
    test::expectRefused(runTool(ACMAP_PAPER_FIGURES, all), exit_code, word);
  }

  static TemporaryFolder* folder_;
  static VirtualDisplay* display_;
};

TemporaryFolder* PaperFigures::folder_ = nullptr;
VirtualDisplay* PaperFigures::display_ = nullptr;

TEST_F(PaperFigures, AllAreDrawnAlikeWithAnyNumberOfThreadsAndAnotherSceneIsTold)
{
  const TemporaryFolder folder;
  std::string text = small_figures;
  text.replace(text.find("corridor_drive"), 14, "loop");
  const std::string figures[] = {folder_->path("small.yaml"),
                                 folder.write("other.yaml", text)};
  for (const std::string threads : {"1", "2"}) {
    const bool is_other = threads == "2";
    auto all = arguments(session(), map(), folder.path(threads), figures[is_other]);
    all.insert(all.end(), {"--threads", threads, "--papers-map", map()});
    const ToolRun run = runTool(ACMAP_PAPER_FIGURES, all).succeeded();
    if (is_other)
      EXPECT_THAT(run.err, HasSubstr("made for scene loop"));
    else
      EXPECT_EQ(run.err, "");
  }
  for (const std::string& name : names) {
    const RgbImage image = loadRgbImage(folder.path("1/" + name));
    EXPECT_EQ(image.width, 300) << name;
    EXPECT_GT(image.height, 60) << name;
    EXPECT_EQ(contentOf(folder.path("1/" + name)), contentOf(folder.path("2/" + name)))
        << name;
  }
  const std::string page = contentOf(folder.path("1/figures.md"));
  for (const char* row : {"| observations | 106 | 3 |",
                          "| patterns an observation | 10 | 3 |",
                          "| lines a pattern | 200 | 200 |",
                          "| image, px | 640 x 480 | 640 x 480 |",
                          "| points an observation | 138,653 | ",
                          "| points in all | 14,697,233 | "})
    EXPECT_THAT(page, HasSubstr(row));
  for (const std::string& name : names)
    EXPECT_THAT(page, HasSubstr("(" + name + ")"));
  for (const std::string name : {"fig8_both.png", "fig9_both.png", "fig10_both.png"}) {
    EXPECT_EQ(loadRgbImage(folder.path("1/" + name)).width, 300);
    EXPECT_THAT(page, HasSubstr("(" + name + ")"));
  }
}

TEST_F(PaperFigures, SessionsWithoutTruthAreRefused)
{
  const TemporaryFolder folder;
  fs::create_directory(folder.path("session"));
  fs::copy(session() + "/session.yaml", folder.path("session"));
  fs::copy(session() + "/rig.yaml", folder.path("session"));
  expectRefused(arguments(folder.path("session"), map(), folder.path("out")),
                3,
                "truth.json: is not there");
  expectRefused(
      arguments(folder.path("none"), map(), folder.path("out")), 3, "truth.json");
  EXPECT_FALSE(fs::exists(folder.path("out")));
}

TEST_F(PaperFigures, MapsOfOtherSessionsAreRefused)
{
  const TemporaryFolder folder;
  const std::string other = copyOfMap(folder);
  folder.write("map/trajectory.txt",
               "0 0 0 0 0 0 0 1\n1 4 0 4 0 0 0 1\n2 8 0 8 0 0 0 1\n");
  expectRefused(arguments(session(), other, folder.path("out")), 3, "is not a map of");
  folder.write("map/trajectory.txt", "0 0 0 0 0 0 0 1\n");
  expectRefused(arguments(session(), other, folder.path("out")), 3, "differ");
  folder.write("map/trajectory_before.txt", "0 0 0 0 0 0 0 1\n");
  expectRefused(arguments(session(), other, folder.path("out")),
                3,
                "it has 1 poses, the session 3");
}

TEST_F(PaperFigures, MapsThatLackPartsAreRefused)
{
  for (const char* part :
       {"map.json", "map.pcd", "trajectory.txt", "trajectory_before.txt"}) {
    const TemporaryFolder folder;
    const std::string other = copyOfMap(folder);
    fs::remove(other + "/" + part);
    expectRefused(arguments(session(), other, folder.path("out")), 3, part);
  }
  const TemporaryFolder folder;
  const std::string other = copyOfMap(folder);
  fs::remove(other + "/stages/observations/observation_0001.pcd");
  expectRefused(
      arguments(session(), other, folder.path("out")), 3, "has 2 observations");
  fs::remove_all(other + "/stages");
  expectRefused(
      arguments(session(), other, folder.path("out")), 3, "stages/observations");
  EXPECT_FALSE(fs::exists(folder.path("out")));
}

TEST_F(PaperFigures, FaultsOfTheFileOfFiguresAreToldWithTheirPlace)
{
  struct Fault {
    const char* from;
    const char* to;
    const char* told;
  };
  const TemporaryFolder folder;
  for (const Fault& fault :
       {Fault{"observation: 2", "observation: 3", "line 5, column 22"},
        Fault{"[0, 1, 2]", "[0, 1, 3]", "has 3 patterns"},
        Fault{"[0, 1, 2]", "[0, 1]", "line 4"},
        Fault{"width: 300", "width: 3", "width"},
        Fault{"width: 300", "high: 300", "high"},
        Fault{"steps: 3", "steps: 0", "steps"},
        Fault{"look: [0, 0, 5]", "look: [0, 5, 0.5]", "straight above or below"},
        Fault{"cut: 1.1, ", "", "cut"}}) {
    std::string text = small_figures;
    text.replace(text.find(fault.from), std::string(fault.from).size(), fault.to);
    const std::string figures = folder.write("bad.yaml", text);
    expectRefused(
        arguments(session(), map(), folder.path("out"), figures), 3, fault.told);
  }
}

TEST_F(PaperFigures, WithoutAnXServerThereAreNone)
{
  const TemporaryFolder folder;
  RunSettings blind;
  blind.environment = {{"DISPLAY", std::nullopt}};
  const ToolRun run = runTool(
      ACMAP_PAPER_FIGURES, arguments(session(), map(), folder.path("out")), blind);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("xvfb-run"));
  EXPECT_FALSE(fs::exists(folder.path("out")));
}

TEST(PaperFiguresUsage, HelpAndNonsense)
{
  const ToolRun help = runTool(ACMAP_PAPER_FIGURES, {"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, HasSubstr("SESSION_DIR"));
  EXPECT_THAT(help.out, HasSubstr("Exit codes"));
  for (const std::vector<std::string>& nonsense :
       std::vector<std::vector<std::string>>{{},
                                             {"a"},
                                             {"a", "b"},
                                             {"a", "b", "-o", "c", "--figures", ""},
                                             {"a", "b", "-o", "c", "d"}})
    EXPECT_EQ(runTool(ACMAP_PAPER_FIGURES, nonsense).exit_code, 2);
}

} // namespace
} // namespace pcl::acmap::test
