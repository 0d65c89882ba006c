#include "live_map.h"

#include "drawn_apart.h"
#include "live_window.h"
#include "map_run.h"
#include "pose_options.h"

#include <pcl/core/impl/part_of_progress.h>
#include <pcl/core/process_memory.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_list.h>
#include <pcl/pipeline/session_pace.h>

#include <algorithm>
#include <filesystem>
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

void
tellSteps(const CompactMappingReport& report, StageLog& log)
{
  log.warn(report.remarks);
  for (const auto& [step, seconds] : report.seconds)
    log.report.seconds.emplace_back(step, seconds);
  if (report.path)
    tellPath(*report.path, log);
  if (report.odometry)
    log.tell("posed",
             std::to_string(report.odometry->posed()) + " of " +
                 std::to_string(report.odometry->poses.size()) + " observations");
  if (report.extension)
    tellExtension(*report.extension, log);
  if (report.rectification)
    log.tell("rectification", report.rectification->reason);
  tellMapping(report.planes, log);
  tellTexture(report.texture, log);
  tellQuality(report, log);
}

} // namespace

LiveMap::LiveMap(const ChainOptions& options,
                 const TrinocularRig& rig,
                 std::string observations,
                 unsigned threads,
                 LiveWindow* window)
: options_(options)
, folder_(std::move(observations))
, window_(window)
{
  mapping_.setNumberOfThreads(threads);
  mapping_.setSettings(settingsOf(options_, threads));
  withDepths([&] {
    return setUpStereo(rig,
                       options_.stereo.sessionSettings(threads),
                       memoryCheck(),
                       mapping_.fusion(),
                       mapping_.backProjection());
  });
  mapping_.setObservationFolder(folder_);
  if (!options_.earlier.empty())
    mapping_.setEarlierObservations(openMappedObservations(options_.earlier));
  mapping_.setStateCallback([this](const MappingState& state) { note(state); });
  if (!window)
    mapping_.setProvisionalInterval(0);
  mapping_.start();
}

LiveMap::~LiveMap()
{
  mapping_.clear(); // its thread writes into the folder
  if (!is_kept_)
    removeObservations();
}

void
LiveMap::removeObservations() const
{
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  fs::remove(fs::path(folder_).parent_path(), ignored); // if nothing else is in it
}

void
LiveMap::keepProcessed(const std::string& fault)
{
  ended_by_ = fault;
  mapping_.keepProcessed();
  is_partial_ = true;
}

void
LiveMap::add(const std::vector<TrinocularFrame::ConstPtr>& frames)
{
  if (!begin_)
    begin_ = Clock::now();
  if (window_ && !frames.empty())
    window_->show(*frames.back());
  for (const TrinocularFrame::ConstPtr& frame : frames)
    mapping_.addFrame(frame);
  mapping_.finishObservation();
}

void
LiveMap::note(const MappingState& state)
{
  const std::lock_guard lock(mutex_);
  processed_ = std::max(processed_, state.processed);
  waits_ += state.is_late ? 1 : 0;
  largest_backlog_ = std::max(largest_backlog_, state.arrived - state.processed);
  largest_lag_ = std::max(largest_lag_, state.lag);
  if (window_)
    news_ = state;
}

void
LiveMap::show()
{
  if (!window_)
    return;
  std::optional<MappingState> news;
  {
    const std::lock_guard lock(mutex_);
    news = std::exchange(news_, std::nullopt);
  }
  if (news)
    window_->show(*news);
  window_->update();
}

void
LiveMap::tellLateness(double recorded, StageLog& log) const
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

std::vector<std::string>
LiveMap::finish(const PicturesApart& pictures,
                OutputFolder& folder,
                const RunControls& controls,
                StageLog& log)
{
  const Clock::time_point last_shot = Clock::now();
  const double recorded = begin_ ? secondsSince(*begin_) : 0;
  mapping_.setScratchFolder(folder.path(""), residentScratch());
  mapping_.setCostCallback(costCheck(controls));
  mapping_.setProgressCallback([&](double done, const std::string& step) {
    show();
    return !controls.progress || controls.progress(0.5 + 0.45 * done, step);
  });
  CompactMap map;
  try {
    mapping_.compute(map);
  }
  catch (const OutputFileException&) {
    if (is_partial_)
      throw;
    keepProcessed(failureOf(std::current_exception()).line);
    mapping_.compute(map);
  }
  const MappedPlanes& found = mapping_.getMappedPlanes();
  made_of_ = map.trajectory.poses.size();
  if (is_partial_) // the map may need their place on the disk
    removeObservations();
  requirePlanes(options_.input, found, log);
  tellSteps(mapping_.getReport(), log);
  saveTrajectory(folder.path(trajectory_name), map.trajectory);
  if (!is_partial_) // else the observations are removed
    saveObservationList((fs::path(options_.output) / observation_list_name).string(),
                        options_.output,
                        mapping_.getMappedSequence());
  if (const Trajectory& before = mapping_.getOdometryTrajectory();
      !before.poses.empty())
    saveTrajectory(folder.path("trajectory_before.txt"), before);
  std::vector<std::string> names = writeMap(
      options_, found, map, pictures, partOf(controls.progress, 0.95, 1), folder, log);
  keep();
  const double after = secondsSince(last_shot);
  const bool is_drawn =
      std::find(names.begin(), names.end(), pictureName("outside.png")) != names.end();
  tellLateness(recorded, log);
  log.details["observations"] = observations();
  if (!ended_by_.empty())
    log.details["ended_by"] = ended_by_;
  log.details["seconds_after_last_shot"] = after;
  log.tell("finished",
           shortNumber(after) + " s after the last shot" +
               (is_drawn ? ", with pictures" : ""));
  return names;
}

std::string
partialMapText(std::size_t observations, const std::string& output)
{
  return "the map of the " + std::to_string(observations) +
         (observations == 1 ? " observation" : " observations") + " by then is in " +
         output;
}

std::optional<MissingObservations>
LiveMap::missing() const
{
  if (ended_by_.empty())
    return std::nullopt;
  return MissingObservations{ended_by_, observations()};
}

void
MissingObservations::fail(const std::string& output) const
{
  const std::string line = ended_by + "; " + partialMapText(observations, output);
  if (ended_by == by_the_user)
    throw InterruptedPartway(line);
  throw OutputFileException(line);
}

namespace {

/** \brief Adds all observations as they come, up to an interruption or a fault. */
void
replay(const SessionSource& session, const RunControls& controls, LiveMap& map)
{
  constexpr double share = 0.5; // of the progress
  const Progress progress(controls.progress);
  const auto count = static_cast<double>(session.size());
  try {
    for (std::size_t i = 0; i < session.size(); ++i) {
      progress.tell(share * static_cast<double>(i) / count, "replaying");
      if (const std::optional<ObservationShots> shots = session.shots(i))
        map.add(shots->frames);
    }
  }
  catch (const CancelledException&) {
    if (map.observations() == 0)
      throw;
    forgetInterruption();
    map.noteInterrupted();
  }
  catch (const OutputFileException&) {
    map.keepProcessed(failureOf(std::current_exception()).line);
  }
}

} // namespace

ReplayedMap
mapAsRecorded(const ChainOptions& options,
              const std::string& observations,
              const PicturesApart& pictures,
              LiveWindow* window,
              OutputFolder& folder,
              const RunControls& controls,
              StageLog& log)
{
  StereoOptions stereo = options.stereo;
  stereo.session = options.input;
  std::optional<LiveMap> map;
  SessionSettings settings = stereo.sessionSettings(controls.threads);
  settings.arrived = SessionPace([&map] {
    stopIfInterrupted();
    map->show();
  });
  const auto session = withDepths([&] {
    return openSession(std::make_shared<TrinocularFileGrabber>(options.input),
                       settings);
  });
  map.emplace(options, session->rig(), observations, controls.threads, window);
  replay(*session, controls, *map);
  ReplayedMap made;
  made.files = map->finish(pictures, folder, controls, log);
  made.missing = map->missing();
  warnOfFindings(log, session->remarks());
  return made;
}

} // namespace pcl::acmap
