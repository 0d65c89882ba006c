#include "chain_runs.h"

#include "plane_runs.h"

#include <gmock/gmock.h>

#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

/** \brief Three views of a corridor by a camera with few pixels. */
constexpr const char* scene = R"(name: short_drive
rig: {width: 320, height: 240, focal_length: 260, center_x: 159.5, center_y: 119.5,
      baseline_horizontal: -0.1, baseline_vertical: -0.1, disparity_sigma: 0.13}
sensor: {reach: 6, points: 34663}
building: corridor
path:
  - line: {from: [0, 0, 0.05], to: [0, 0, 0.85], views: 3, yaw: [0, 5, 0]}
)";

/** \brief Also copies the times of the files, by which stages detect changes. */
void
copyWhole(const std::string& from, const std::string& to)
{
  fs::remove_all(to);
  ASSERT_EQ(runTool("cp", {"-a", from, to}).exit_code, 0) << from;
}

/** \brief The session and its map, made once per program, and copies that are never
 * changed. */
class Kept {
public:
  Kept()
  {
    const std::vector<std::string> filming = {"-o",
                                              session(),
                                              "--scene",
                                              folder_.write("scene.yaml", scene),
                                              "--patterns",
                                              "3"};
    const ToolRun rig = runTool(ACMAP_SIMULATED_RIG, filming);
    EXPECT_EQ(rig.exit_code, 0) << rig.err;
    const ToolRun chain = runSessionChain(session(), map(), {"--threads", "2"});
    EXPECT_EQ(chain.exit_code, 0) << chain.err;
    // with three views, noise may look like curved surfaces; there is no other warning
    EXPECT_THAT(
        chain.err,
        testing::MatchesRegex("(pcl_compact_mapping: warning: [0-9]+ points lie "
                              "on curved surfaces, which are no planes\n)?"));
    copyWhole(session(), folder_.path("kept session"));
    copyWhole(map(), folder_.path("kept map"));
  }

  void
  restore() const
  {
    copyWhole(folder_.path("kept session"), session());
    copyWhole(folder_.path("kept map"), map());
  }

  std::string
  session() const
  {
    return folder_.path("session");
  }

  std::string
  map() const
  {
    return folder_.path("map");
  }

private:
  TemporaryFolder folder_;
};

const Kept&
kept()
{
  static const Kept kept;
  return kept;
}

} // namespace

ToolRun
runChain(const std::string& input,
         const std::string& output,
         const std::vector<std::string>& options,
         RunSettings settings)
{
  settings.environment.emplace(settings.environment.begin(), "DISPLAY", std::nullopt);
  return runTool(ACMAP_COMPACT_MAPPING,
                 joined({input, "-o", output, "--no-pictures"}, options),
                 settings);
}

ToolRun
runSessionChain(const std::string& session,
                const std::string& output,
                std::vector<std::string> options,
                const RunSettings& settings)
{
  options.insert(options.end(), {"--min-depth", "1"}); // halves the disparities
  return runChain(session, output, options, settings);
}

std::vector<std::string>
stagesOf(const std::string& output)
{
  std::vector<std::string> names;
  const auto report = jsonOfFile(output + "/report.json");
  for (const auto& stage : report.at("stages"))
    names.push_back(stage.at("name"));
  return names;
}

std::vector<std::string>
madeStages(const std::string& output)
{
  std::vector<std::string> names;
  const auto report = jsonOfFile(output + "/report.json");
  for (const auto& stage : report.at("stages"))
    if (!stage.at("reused").get<bool>())
      names.push_back(stage.at("name"));
  return names;
}

std::map<std::string, std::string>
resultsIn(const std::string& folder)
{
  std::map<std::string, std::string> results;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && name != "report.json" && name != "report.html" &&
        name != "stage.json")
      results[fs::relative(entry.path(), folder).string()] =
          contentOf(entry.path().string());
  }
  return results;
}

std::vector<std::string>
differing(const std::map<std::string, std::string>& a,
          const std::map<std::string, std::string>& b)
{
  std::vector<std::string> names;
  for (const auto& [name, bytes] : a)
    if (const auto there = b.find(name); there == b.end() || there->second != bytes)
      names.push_back(name);
  for (const auto& file : b)
    if (a.count(file.first) == 0)
      names.push_back(file.first);
  return names;
}

std::vector<std::string>
hiddenIn(const std::string& folder)
{
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename().string().front() == '.')
      paths.push_back(entry.path().string());
  return paths;
}

void
ChainTest::SetUp()
{
  kept().restore();
  session_ = kept().session();
  map_ = kept().map();
}

ToolRun
ChainTest::runAgain(const std::vector<std::string>& options,
                    const RunSettings& settings) const
{
  return runSessionChain(session_, map_, options, settings);
}

std::string
ChainTest::observations() const
{
  const std::string folder = folder_.path("observations");
  fs::copy(map_ + "/stages/observations", folder);
  fs::remove(folder + "/stage.json");
  return folder;
}

std::string
ChainTest::posedObservations() const
{
  std::string folder = observations();
  fs::copy(map_ + "/trajectory.txt", folder + "/trajectory.txt");
  return folder;
}

} // namespace pcl::acmap::test
