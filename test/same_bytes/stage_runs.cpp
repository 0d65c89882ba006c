#include "stage_runs.h"

#include "rendered_boards.h"
#include "run_tool.h"

#include <pcl/core/image_file.h>
#include <pcl/core/rig_calibration.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

void
writeBoards(const std::string& folder)
{
  fs::create_directory(folder);
  saveRigCalibration(folder + "/rig.yaml", {}, builtRig());
  const std::vector<TrinocularFrame> shots = boardShots(builtRig(), board_shots);
  for (std::size_t i = 0; i < shots.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const CameraImage& image = shots[i].images[k];
      savePng(folder + "/" + shotNames(i)[k], image.width, image.height, image.values);
    }
}

/** Is it a row of a summary (name and text) that tells times, as a replay's pace? */
bool
isRowOfSeconds(const nlohmann::json& value)
{
  if (!value.is_array() || value.size() != 2 || !value[1].is_string())
    return false;
  const auto text = value[1].get<std::string>();
  return value[0] == "seconds" ||
         text.find(" s after the last shot") != std::string::npos ||
         text.find("the mapping lagged by") != std::string::npos;
}

void
dropWhatChanges(nlohmann::json& value)
{
  if (value.is_object()) {
    for (auto item = value.begin(); item != value.end();)
      if (item.key().find("seconds") != std::string::npos ||
          item.key() == "command_line" || item.key() == "peak_memory_bytes")
        item = value.erase(item);
      else
        dropWhatChanges(*item++);
  }
  else if (value.is_array()) {
    for (auto& one : value)
      if (isRowOfSeconds(one))
        one.clear();
      else
        dropWhatChanges(one);
  }
}

} // namespace

std::string
comparable(const std::string& name, const std::string& content)
{
  if (name == "stage.json" || name == "report.html")
    return "";
  if (name != "report.json")
    return content;
  auto report = nlohmann::json::parse(content);
  dropWhatChanges(report);
  return report.dump(1);
}

StageRuns::StageRuns()
{
  fs::copy_file(ACMAP_SAME_BYTES_SCENE, folder_.path(scene_file));
  writeBoards(folder_.path(boards_folder));
  const std::string clouds = folder_.path("clouds");
  const ToolRun simulated =
      runTool(std::string(ACMAP_BIN) + "/pcl_simulated_rig",
              {"-o", clouds, "--scene", folder_.path(scene_file), "--clouds"});
  EXPECT_EQ(simulated.exit_code, 0) << simulated.err;
  const ToolRun written = runTool(std::string(ACMAP_BIN) + "/write_rgbd_recording",
                                  {clouds, folder_.path(recording_folder)});
  EXPECT_EQ(written.exit_code, 0) << written.err;
}

std::string
StageRuns::resolved(const Stage& stage, const std::string& argument) const
{
  if (argument.front() == '<')
    return folder_.path(argument.substr(1));
  if (argument.front() == '>')
    return folderOf(stage) + "/" + argument.substr(1);
  return argument;
}

Files
StageRuns::run(const Stage& stage, const Variant& variant)
{
  const std::string made = folderOf(stage);
  fs::remove_all(made);
  fs::create_directory(made);
  std::vector<std::string> arguments;
  for (const std::string& argument : stage.arguments)
    arguments.push_back(resolved(stage, argument));
  arguments.insert(arguments.end(), {"--report", made + "/report.json"});
  if (stage.has_threads)
    arguments.insert(arguments.end(), {"--threads", std::to_string(variant.threads)});
  RunSettings settings;
  if (variant.is_plain)
    settings.environment = {{"ACMAP_SIMD", "base"}};
  const ToolRun run =
      runTool(std::string(ACMAP_BIN) + "/" + stage.program, arguments, settings);
  EXPECT_EQ(run.exit_code, 0) << stage.name << ": " << run.err;
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(made))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), made).string()] = comparable(
          entry.path().filename().string(), contentOf(entry.path().string()));
  return files;
}

const Files&
StageRuns::firstOf(const Stage& stage)
{
  for (const Stage& each : stageTable()) {
    const bool is_asked = each.name == stage.name;
    if (first_.count(each.name) == 0 && (is_asked || !each.needs_display))
      first_[each.name] = run(each, {});
    if (is_asked)
      break;
  }
  return first_.at(stage.name);
}

} // namespace pcl::acmap::test
