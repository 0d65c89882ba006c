#include "observation_list.h"

#include "output_target.h"

#include <pcl/core/trajectory.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

/** Poses of the input are not used, so that invalid ones are no error. */
void
takeStamps(Tool& tool, const std::string& folder, ObservationList& list)
{
  const std::string path = (fs::path(folder) / trajectory_name).string();
  std::error_code error;
  if (!fs::exists(path, error))
    return;
  try {
    const Trajectory trajectory = loadTrajectory(path);
    const std::vector<std::size_t> rows =
        trajectoryRows(path, list.names, trajectory.stamps.size());
    std::transform(rows.begin(), rows.end(), list.stamps.begin(), [&](std::size_t row) {
      return trajectory.stamps[row];
    });
  }
  catch (const InputFileException&) {
    tool.warn("stamps are numbers, as those of the input cannot be used: " +
              failureOf(std::current_exception()).line);
  }
}

bool
comeBackInOrder(const std::vector<std::string>& names)
{
  return inSequence(names) == names &&
         std::adjacent_find(names.begin(), names.end()) == names.end() &&
         std::all_of(names.begin(), names.end(), [](const std::string& name) {
           return endingOf(name) == ".pcd";
         });
}

} // namespace

ObservationList
listObservations(Tool& tool,
                 const std::vector<std::string>& inputs,
                 const std::optional<ObservationSequence>& opened)
{
  std::error_code error;
  const bool is_folder =
      inputs.size() == 1 &&
      (fs::is_directory(inputs.front(), error) || endingOf(inputs.front()) != ".pcd");
  ObservationList list{
      opened ? *opened
             : ObservationSequence(
                   is_folder ? observationPaths(inputs.front()) : inputs, tool.scale()),
      {},
      {},
      {}};
  list.names = list.sequence.names();
  list.stamps.resize(list.names.size());
  std::iota(list.stamps.begin(), list.stamps.end(), 0.0);
  if (is_folder)
    takeStamps(tool, inputs.front(), list);
  list.outputs = list.names;
  if (!comeBackInOrder(list.names)) {
    for (std::size_t i = 0; i < list.outputs.size(); ++i)
      list.outputs[i] = observationName(i);
    tool.warn("the observations are named anew, since a folder would have them in "
              "another order than the one given");
  }
  return list;
}

void
requireFit(const OutputFolder& folder, const ObservationSequence& sequence)
{
  for (std::size_t i = 0; i < sequence.size(); ++i)
    if (folder.holds(sequence.path(i)))
      throw UsageError(folder.name() + ": holds the input; name another folder");
  requireNoneIn(folder, [](const std::string& name) {
    // replacing a report would leave the map without its own
    return isSequenceName(name) || endingOf(name) == ".pcd" || name == "plan.png" ||
           name == "report.json" || name.rfind("map.", 0) == 0 ||
           name.rfind("matches_", 0) == 0;
  });
}

} // namespace pcl::acmap
