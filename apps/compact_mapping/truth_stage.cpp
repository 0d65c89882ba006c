#include "map_stage.h"

#include <pcl/core/map_file.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <filesystem>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

/** \brief The trajectory of the map, without observations that the map left out.
 * \param[in] before one row per observation of the folder */
MappedTrajectory
trajectoryOf(const ObservationSequence& posed,
             const Trajectory& before,
             const Trajectory& after,
             const SessionTruth& truth)
{
  const std::vector<std::size_t> rows = trajectoryRows(
      truth.trajectory_path, posed.names(), truth.trajectory.poses.size());
  MappedTrajectory mapped;
  for (std::size_t i = 0, row = 0; i < posed.size() && row < after.poses.size(); ++i) {
    if (posed.stamp(i) != after.stamps[row])
      continue;
    mapped.observations.push_back(rows[i]);
    mapped.after.push_back(after.poses[row]);
    mapped.before.push_back(before.poses.empty() ? after.poses[row]
                                                 : before.poses.at(i));
    ++row;
  }
  return mapped;
}

} // namespace

MapFigures
compareMap(const ChainOptions& options,
           const ChainState& made,
           const StageLog& told,
           const SessionTruth& truth)
{
  const CompactMap map = loadMapFile((fs::path(options.output) / "map.json").string());
  MapFigures figures = compareWithTruth(
      map, trajectoryOf(*made.observations, made.before, map.trajectory, truth), truth);
  const auto& bytes = told.details.at("bytes");
  figures.compactness =
      bytes.at("raw").get<double>() / std::max(bytes.at("textured").get<double>(), 1.0);
  return figures;
}

} // namespace pcl::acmap
