#include <pcl/core/output_folder.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/observation_writing.h>

namespace pcl::acmap {

Trajectory
writeObservations(
    const OutputFolder& folder,
    std::size_t count,
    const std::function<std::optional<ObservationToWrite>(std::size_t)>& make,
    const ObservationWriting& writing)
{
  const Progress progress(writing.progress);
  Trajectory trajectory;
  for (std::size_t i = 0; i < count; ++i) {
    progress.tell(static_cast<double>(i) / static_cast<double>(count), writing.step);
    const std::optional<ObservationToWrite> made = make(i);
    if (!made)
      continue;
    const std::string name =
        made->name.empty() ? observationName(trajectory.poses.size()) : made->name;
    saveObservation(folder.path(name), *made->cloud, made->T_map_camera);
    trajectory.stamps.push_back(made->stamp);
    trajectory.poses.push_back(made->T_map_camera);
    if (writing.written)
      writing.written(*made);
  }
  return trajectory;
}

void
writeObservations(const OutputFolder& folder,
                  ObservationSequence sequence,
                  const ObservationWriting& writing)
{
  sequence.setCacheSize(0); // each is read once
  const auto read = [&](std::size_t i) -> std::optional<ObservationToWrite> {
    const PosedObservation seen = sequence.load(i);
    return {{sharedCloud(seen.file),
             seen.T_map_camera,
             sequence.stamp(i),
             sequence.name(i)}};
  };
  const Trajectory trajectory =
      writeObservations(folder, sequence.size(), read, writing);
  if (sequence.hasTrajectory())
    saveTrajectory(folder.path(trajectory_name), trajectory);
  else
    saveTimes(folder.path(times_name), trajectory.stamps);
}

} // namespace pcl::acmap
