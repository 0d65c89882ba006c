#include "clouds.h"
#include "every_tool.h"
#include "rgbd_folders.h"
#include "tool_cases.h"
#include "trial_page.h"
#include "virtual_display.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

// The page of the new user's trial is the table of this test: each section is run in a
// separate folder, row after row, as a user would type it.

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

const std::string page = contentOf(ACMAP_SOURCE "/doc/new_user_trial.md");

const std::vector<TrialSection>&
sections()
{
  static const std::vector<TrialSection> all = parseTrial(page);
  return all;
}

std::vector<std::string>
toolNames()
{
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(ACMAP_TOOLS))
    if (const std::string name = entry.path().filename().string();
        name.rfind("pcl_", 0) == 0)
      names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

/** \brief The files of the user, see the page. */
class Belongings {
public:
  Belongings()
  {
    constexpr double spacing = 0.015, noise = 0.8; // metres, spacings
    const Cloud room = makeRoom(spacing, noise, 1);
    folder_.write("office.pcd", pcdText(room));
    folder_.write("office_mm.pcd", pcdText(scaled(room, 1000)));
    fs::copy(ACMAP_SOURCE "/share/logs/corridor_loop.log.gz",
             folder_.path("laser.log.gz"));
    const std::string unpack =
        "gzip -dc " + folder_.path("laser.log.gz") + " > " + folder_.path("laser.log");
    if (std::system(unpack.c_str()) != 0)
      throw std::runtime_error("gzip is needed");
    fs::copy(folder_.path("laser.log"), folder_.path("laser.txt"));
    for (const char* name : {"scene.yaml", "session", "map", "posed"})
      fs::copy(
          smallInputs().path(name), folder_.path(name), fs::copy_options::recursive);
    makeRecordings();
    makeUnposed();
  }

  const TemporaryFolder&
  folder() const
  {
    return folder_;
  }

private:
  void
  makeRecordings() const
  {
    const TemporaryFolder tum, seven_scenes;
    writeTum(tum, 2);
    fs::copy(tum.path(""), folder_.path("recording_tum"), recursive);
    writeSevenScenes(seven_scenes, 2);
    fs::copy(seven_scenes.path(""), folder_.path("recording_7scenes"), recursive);
    const fs::path open3d = folder_.path("recording_open3d");
    fs::create_directories(open3d / "color");
    fs::create_directories(open3d / "depth");
    for (const auto& entry :
         fs::directory_iterator(folder_.path("recording_7scenes"))) {
      const std::string name = entry.path().filename().string(); // frame-000000.…
      for (const char* kind : {"color", "depth"})
        if (name.find(kind) != std::string::npos)
          fs::copy(entry.path(), open3d / kind / (name.substr(6, 6) + ".png"));
    }
  }

  /** \brief Two clouds without known poses. */
  void
  makeUnposed() const
  {
    fs::create_directories(folder_.path("unposed"));
    for (const char* name : {"observation_0000.pcd", "observation_0001.pcd"})
      fs::copy(folder_.path("office.pcd"), folder_.path("unposed/") + name);
  }

  static constexpr auto recursive = fs::copy_options::recursive;
  TemporaryFolder folder_;
};

const TemporaryFolder&
belongings()
{
  static const Belongings all;
  return all.folder();
}

std::set<std::string>
namesBelow(const std::string& folder)
{
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    names.insert(entry.path().string());
  return names;
}

void
expectWords(const std::vector<std::string>& words, const std::string& text)
{
  for (const std::string& word : words)
    EXPECT_NE(text.find(word), std::string::npos) << word << "\nis not in\n" << text;
}

void
tryRow(const TrialRow& row, const std::string& command, const std::string& folder)
{
  SCOPED_TRACE("line " + std::to_string(row.line) + ": " + command);
  RunSettings settings;
  settings.folder = folder;
  settings.environment = {{"PATH", std::string(ACMAP_TOOLS ":") + std::getenv("PATH")}};
  const std::set<std::string> before = namesBelow(folder);
  const ToolRun run = runTool("/bin/sh", {"-c", command}, settings);
  EXPECT_EQ(run.exit_code, row.exit_code) << run.err;
  expectWords(row.prints, run.out);
  expectWords(row.says, run.err);
  for (const std::string& name : row.writes)
    EXPECT_TRUE(fs::exists(folder + "/" + name)) << name << "\n" << run.err;
  if (row.exit_code == 0) {
    EXPECT_EQ(run.err.empty(), row.says.empty()) << run.err;
    return;
  }
  EXPECT_FALSE(row.says.empty()) << "a refusal says why";
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.errorLines(), 1u) << run.err;
  EXPECT_EQ(run.err.rfind("pcl_", 0), 0u) << run.err;
  EXPECT_EQ(namesBelow(folder), before) << "a refused run leaves nothing";
}

bool
needsScreen(const TrialRow& row)
{
  return row.command.find("--screenshot") != std::string::npos;
}

class NewUser : public testing::TestWithParam<std::size_t> {};

TEST_P(NewUser, GetsWhatThePageTells)
{
  const VirtualDisplay& display = VirtualDisplay::shared();
  const TemporaryFolder folder;
  fs::copy(belongings().path(""), folder.path("home"), fs::copy_options::recursive);
  const std::string place = "TOOL";
  for (const TrialRow& row : sections()[GetParam()].rows) {
    if (needsScreen(row) && !display.exists())
      continue;
    const std::size_t at = row.command.find(place);
    if (at == std::string::npos) {
      tryRow(row, row.command, folder.path("home"));
      continue;
    }
    for (const std::string& name : toolNames())
      tryRow(row,
             std::string(row.command).replace(at, place.size(), name),
             folder.path("home"));
  }
}

std::string
nameOf(const testing::TestParamInfo<std::size_t>& section)
{
  std::string name;
  for (const char letter : sections()[section.param].title)
    name += std::isalnum(static_cast<unsigned char>(letter)) ? letter : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Trial,
                         NewUser,
                         testing::Range(std::size_t{0}, sections().size()),
                         nameOf);

TEST(NewUserTrial, KnowsEveryTool)
{
  EXPECT_GE(toolNames().size(), 14u);
  EXPECT_GE(sections().size(), 4u);
}

/** The commands of the README are run as well, word for word. */
TEST(NewUserTrial, TriesTheReadmesCommands)
{
  const std::string readme = contentOf(ACMAP_SOURCE "/README.md");
  for (const std::string& command : commandsUnder("**A tool on files.**", readme)) {
    bool is_tried = false;
    for (const TrialSection& section : sections())
      for (const TrialRow& row : section.rows)
        is_tried = is_tried || row.command.rfind(command, 0) == 0;
    EXPECT_TRUE(is_tried) << command;
  }
}

} // namespace
} // namespace pcl::acmap::test
