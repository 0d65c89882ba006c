#include "recorded_stage.h"

#include "active_stereo/shot_source.h"
#include "active_stereo/stereo_observation.h"

#include <pcl/pipeline/compact_mapping.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <utility>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double
secondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/** \brief Sets all steps as the stages of the chain set theirs. */
void
setUp(const ChainOptions& options,
      const TrinocularRig& rig,
      const RunControls& controls,
      CompactMapping& mapping)
{
  mapping.setNumberOfThreads(controls.threads);
  if (options.planes.paper)
    mapping.setMode(MappingMode::Paper);
  setUpStereo(rig,
              options.stereo,
              controls.threads,
              mapping.fusion(),
              mapping.backProjection());
  VisualOdometry odometry;
  odometry.setEgomotion(egomotionOf(options.egomotion));
  mapping.setVisualOdometry(odometry);
  CompactMapping::Levelling levelling;
  if (options.rectification.up)
    levelling.setUpDirection(*options.rectification.up);
  mapping.setLevelling(levelling);
  mapping.setRectification(rectificationOf(options.rectification));
  mapping.setRectify(options.rectifies);
  mapping.setAdjust(options.egomotion.is_rigid);
  mapping.setMerging(mergingOf(options, controls.threads));
  mapping.setPlaneMapping(mappingOf(options.planes, controls.threads));
  mapping.setTexturing(texturingOf(options.texture, controls.threads));
}

/** \brief How late the mapping was while frames arrived. */
class Lateness {
public:
  /** \brief Thread-safe. */
  void
  note(const MappingState& state)
  {
    const std::lock_guard lock(mutex_);
    waits_ += state.is_late ? 1 : 0;
    largest_backlog_ = std::max(largest_backlog_, state.arrived - state.processed);
    largest_lag_ = std::max(largest_lag_, state.lag);
  }

  void
  tell(double recorded, StageLog& log) const
  {
    log.details["recorded_seconds"] = recorded;
    log.details["largest_lag_seconds"] = largest_lag_;
    log.details["waits"] = waits_;
    log.tell("recorded",
             "in " + shortNumber(recorded) + " s; the mapping lagged by at most " +
                 std::to_string(largest_backlog_) + " observations, " +
                 shortNumber(largest_lag_) + " s");
    if (waits_ > 0)
      log.warn("the camera had to wait " + std::to_string(waits_) +
               " times, because the mapping was too far behind");
  }

private:
  std::mutex mutex_;
  std::size_t waits_ = 0;
  std::size_t largest_backlog_ = 0;
  double largest_lag_ = 0;
};

/** \brief Adds all observations as they come. \return seconds that it took */
double
replay(ShotSource& source, const RunControls& controls, CompactMapping& mapping)
{
  constexpr double share = 0.5; // of the progress
  const Clock::time_point begin = Clock::now();
  const Progress progress(controls.progress);
  double done = 0;
  while (true) {
    progress.tell(share * done, "replaying");
    ComingShots coming = source.next();
    done = coming.done;
    if (!coming.shots)
      return secondsSince(begin);
    for (const TrinocularFrame::ConstPtr& frame : coming.shots->frames)
      mapping.addFrame(frame);
    mapping.finishObservation();
  }
}

/** \brief Removes the observations of a replay that was not finished. */
class ObservationFolder {
public:
  explicit ObservationFolder(std::string path)
  : path_(std::move(path))
  {}

  ObservationFolder(const ObservationFolder&) = delete;
  ObservationFolder&
  operator=(const ObservationFolder&) = delete;

  ~ObservationFolder()
  {
    if (is_finished_)
      return;
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    fs::remove(fs::path(path_).parent_path(), ignored); // if nothing else is in it
  }

  const std::string&
  path() const
  {
    return path_;
  }

  void
  finish()
  {
    is_finished_ = true;
  }

private:
  std::string path_;
  bool is_finished_ = false;
};

void
tellSteps(const CompactMappingReport& report, StageLog& log)
{
  log.warn(report.remarks);
  for (const auto& [step, seconds] : report.seconds)
    log.report.seconds.emplace_back(step, seconds);
  if (report.odometry)
    log.tell("posed",
             std::to_string(report.odometry->posed()) + " of " +
                 std::to_string(report.odometry->poses.size()) + " observations");
  if (report.rectification)
    log.tell("rectification", report.rectification->reason);
  tellMapping(report.planes, log);
  tellTexture(report.texture, log);
}

} // namespace

std::vector<std::string>
mapAsRecorded(const ChainOptions& options,
              const std::string& observations,
              bool draws,
              OutputFolder& folder,
              const RunControls& controls,
              StageLog& log)
{
  StereoOptions stereo = options.stereo;
  stereo.session = options.input;
  ShotSource source(stereo, controls.threads, ReplayPace::AsRecorded);
  ObservationFolder kept(observations); // longer than the thread that writes into it
  CompactMapping mapping;
  setUp(options, source.rig(), controls, mapping);
  Lateness lateness;
  mapping.setObservationFolder(kept.path());
  mapping.setStateCallback([&](const MappingState& state) { lateness.note(state); });
  mapping.start();
  const double recorded = replay(source, controls, mapping);
  const Clock::time_point last_shot = Clock::now();
  mapping.setProgressCallback([&](double done, const std::string& step) {
    return !controls.progress || controls.progress(0.5 + done / 2, step);
  });
  Mapped mapped;
  mapping.compute(mapped.map);
  mapped.found = mapping.getMappedPlanes();
  requirePlanes(options.input, mapped.found, log);
  warnOfFindings(log, source.remarks());
  tellSteps(mapping.getReport(), log);
  saveTrajectory(folder.path(trajectory_name), mapped.map.trajectory);
  if (const Trajectory& before = mapping.getOdometryTrajectory(); !before.poses.empty())
    saveTrajectory(folder.path("trajectory_before.txt"), before);
  std::vector<std::string> names = writeMap(options, mapped, draws, folder, log);
  kept.finish();
  const double after = secondsSince(last_shot);
  lateness.tell(recorded, log);
  log.details["seconds_after_last_shot"] = after;
  log.tell("map",
           shortNumber(after) + " s after the last shot" +
               (draws ? ", with pictures" : ""));
  return names;
}

} // namespace pcl::acmap
