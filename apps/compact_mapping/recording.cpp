#include "recording.h"

#include "output_target.h"
#include "tool.h"

#include <pcl/core/output_folder.h>
#include <pcl/core/scan_file.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_source.h>

namespace pcl::acmap {

namespace {

/** \brief Number of scans of an E57 file; 0 if that cannot be told. */
std::size_t
scansOf(const std::string& path)
{
  try {
    return ScanFile::count(path);
  }
  catch (const InputFileException&) {
    return 0; // the fault is told when the file is read as one cloud
  }
}

} // namespace

std::optional<ObservationSequence>
openRecording(const std::string& path, std::size_t every)
{
  const std::string ending = endingOf(path);
  if (ending == ".mcap")
    return ObservationSequence(openBag(path, every));
  if (ending == ".e57" && scansOf(path) > 1)
    return ObservationSequence(openScans(path));
  return {};
}

void
importRecording(const std::string& path,
                ObservationSequence sequence,
                const std::string& folder,
                const RunControls& controls,
                StageLog& log)
{
  StepTimer timer(log.report);
  sequence.setCacheSize(0); // each is read once
  const Progress progress(controls.progress);
  OutputFolder output(folder);
  Trajectory trajectory;
  std::size_t points = 0;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    progress.tell(static_cast<double>(i) / static_cast<double>(sequence.size()),
                  "reading " + path);
    const PosedObservation seen = sequence.load(i);
    points += seen.file->points().size();
    saveObservation(output.path(sequence.name(i)), seen.file->cloud, seen.T_map_camera);
    trajectory.stamps.push_back(sequence.stamp(i));
    trajectory.poses.push_back(seen.T_map_camera);
  }
  if (sequence.hasTrajectory())
    saveTrajectory(output.path(trajectory_name), trajectory);
  else
    saveTimes(output.path(times_name), trajectory.stamps);
  stopIfInterrupted();
  output.commit();
  timer.finish("import");
  log.warn(sequence.remarks());
  const Eigen::Vector3d& shift = sequence.shift();
  log.details = {{"input", path},
                 {"observations", sequence.size()},
                 {"points", points},
                 {"shift", {shift.x(), shift.y(), shift.z()}}};
  log.tell("observations", std::to_string(sequence.size()));
  log.tell("points", std::to_string(points));
}

} // namespace pcl::acmap
