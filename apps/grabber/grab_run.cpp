#include "compact_mapping/live_map.h"
#include "drawn_apart.h"
#include "grabber_options.h"
#include "live_window.h"
#include "output_target.h"
#include "terminal.h"

#include <pcl/acquisition/frame_stream.h>
#include <pcl/acquisition/guarded_projector.h>
#include <pcl/acquisition/pattern_selection.h>
#include <pcl/acquisition/pattern_sequence_grabber.h>
#include <pcl/acquisition/pattern_window.h>
#include <pcl/acquisition/projector_latency.h>
#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/conversions.h>
#include <pcl/core/calibration_file.h>
#include <pcl/core/camera_exception.h>
#include <pcl/core/fields_json.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/process_memory.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/pattern_need.h>

#include <filesystem>
#include <thread>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

/** \brief The source of the frames: a camera, or a recording. */
struct Device {
  std::unique_ptr<GrabbedCamera> camera;       ///< null for a recording
  shared_ptr<TrinocularFileGrabber> recording; ///< null for a camera
  TrinocularRig rig;                           ///< rig of the frames

  /** \brief The unrectified cameras, if the rig's file has them: frames are then not
   * rectified. */
  std::optional<RigCalibration> cameras;
};

/** \throws NothingFound when there is no such camera */
std::unique_ptr<GrabbedCamera>
openCamera(const GrabbedCameraOpener& opener, const TrinocularRig& rig)
{
  try {
    return opener(rig);
  }
  catch (const CameraException& error) {
    if (error.fault() == CameraFault::NotFound)
      throw NothingFound(failureOf(std::current_exception()).line);
    throw;
  }
}

/** \brief Opens the device.
 * \throws what the opener of the camera throws
 * \throws InputFileException when rig or recording cannot be read */
Device
openDevice(const GrabberOptions& options,
           const GrabbedCameraOpener& opener,
           StageLog& log)
{
  Device device;
  if (options.isRecording()) {
    constexpr float fastest = 1000; // frames per second
    device.recording.reset(new TrinocularFileGrabber(options.recording(), fastest));
    device.recording->setSkipBroken(true);
    device.rig = device.recording->getRig();
  }
  else {
    RigImages images;
    images.of_camera = true;
    const CalibratedRig found = loadRig({options.rig}, images);
    log.tell("rig", found.told);
    device.rig = found.rig;
    device.cameras = found.cameras;
    device.camera = openCamera(opener, device.rig);
  }
  if (options.isRecording() && hasBuiltCameras(options.rigPath()))
    device.cameras = loadRigCalibration(options.rigPath());
  if (device.camera && device.cameras)
    device.camera->setCalibration(*device.cameras);
  return device;
}

/** \brief The projector, and the grabber that synchronises the camera with it. */
struct Projection {
  MonitorPlace monitor;
  shared_ptr<PatternSequenceGrabber> sequence;
};

std::vector<RgbImage>
drawPatterns(const GrabberOptions& options, const MonitorPlace& monitor, StageLog& log)
{
  PatternOptions pattern = options.pattern;
  pattern.size = std::to_string(monitor.width) + "x" + std::to_string(monitor.height);
  RandomLinePattern generator = generatorOf(pattern);
  requireMemory(std::size_t{3} * pattern.patterns *
                    static_cast<std::size_t>(monitor.width) *
                    static_cast<std::size_t>(monitor.height),
                "the patterns");
  if (options.selects)
    return PatternSelection().selectFrom(generator, pattern.patterns);
  std::vector<RgbImage> patterns;
  for (std::uint32_t i = 0; i < pattern.patterns; ++i) {
    stopIfInterrupted();
    patterns.push_back(generator.generate(i));
    log.warn(generator.getReport().remarks);
  }
  return patterns;
}

double
settleTime(const GrabberOptions& options,
           const Device& device,
           const MonitorPlace& monitor,
           const shared_ptr<PatternProjector>& projector,
           StatusLine& status,
           StageLog& log)
{
  constexpr double usual_settle_time = 0.1; // seconds
  if (options.settle.number)
    return *options.settle.number;
  if (!options.settle.is_auto)
    return usual_settle_time;
  const std::size_t pixels = static_cast<std::size_t>(monitor.width) *
                             static_cast<std::size_t>(monitor.height);
  const RgbImage white{
      monitor.width, monitor.height, std::vector<std::uint8_t>(3 * pixels, 255)};
  const auto measured = measureSettleTime(device.camera->grabber(), projector, white);
  device.camera->grabber()->rewind();
  if (!measured) {
    log.warn("the settle time could not be measured: the camera sees the projector's "
             "light too faintly, or too late; it is taken as usual");
    return usual_settle_time;
  }
  status.note("the projector settles in " + shortNumber(*measured) + " s");
  return *measured;
}

/** \brief Opens the projector, draws the patterns, and measures what of camera and
 * projector is unknown.
 * \param[in] drawing is locked while the projector's window is drawn, since Xlib is not
 * thread-safe; outlives the projection
 * \throws BadArgumentException, IOException as \ref PatternWindow
 * \throws MemoryLimitException when the patterns do not fit
 * \throws CameraException when a shot fails
 * \throws CancelledException when the user interrupted it */
Projection
openProjection(const GrabberOptions& options,
               const Device& device,
               std::mutex& drawing,
               StatusLine& status,
               StageLog& log)
{
  const shared_ptr<PatternWindow> window(new PatternWindow(
      static_cast<std::size_t>(options.pattern.monitor), options.display));
  const shared_ptr<PatternProjector> projector(new GuardedProjector(drawing, window));
  Projection projection;
  projection.monitor = window->getMonitor();
  std::vector<RgbImage> patterns = drawPatterns(options, projection.monitor, log);
  device.camera->check(*projector, patterns, status, log);
  const double settle =
      settleTime(options, device, projection.monitor, projector, status, log);
  projection.sequence.reset(new PatternSequenceGrabber(
      device.camera->grabber(), projector, std::move(patterns)));
  projection.sequence->setSettleTime(settle);
  projection.sequence->setShotTimeout(device.camera->shotTimeout());
  return projection;
}

FrameRectifier
rectifierOf(const GrabberOptions& options, const Device& device, unsigned threads)
{
  return {options.rigPath(), device.rig, device.cameras, threads};
}

/** \brief The observations of a run as point clouds, as pcl_active_stereo computes them
 * for a session. Their files are in the folder's hidden part until it is committed. */
struct CloudOutput {
  CloudOutput(const GrabberOptions& options, const Device& device, unsigned threads)
  : rectifier(rectifierOf(options, device, threads))
  , fusion(withDepths([&] {
    return ShotFusion(
        rectifier.rig(), options.map.stereo.sessionSettings(threads), memoryCheck());
  }))
  {
    if (!options.clouds.empty())
      requireNoneIn(folder.emplace(options.clouds), isConvertedName);
  }

  FrameRectifier rectifier;
  ShotFusion fusion;
  std::optional<OutputFolder> folder; ///< nothing if clouds are only shown
  ShotGroups groups;
  ConvertedSession converted;
};

/** \brief The map of a run. Its files are in the folder's hidden part until it is
 * committed, its observations in its stages. */
struct MapOutput {
  MapOutput(const GrabberOptions& options,
            const Device& device,
            unsigned threads,
            LiveWindow* live)
  : settings(options.map)
  , folder(settings.output)
  , observations((fs::path(settings.output) / "stages" / "replay").string())
  , rectifier(rectifierOf(options, device, threads))
  {
    requireNoneIn(folder, [](const std::string&) { return true; });
    settings.input = options.isRecording() ? options.recording() : "the camera";
    map.emplace(settings, rectifier.rig(), observations, threads, live);
  }

  ChainOptions settings;
  OutputFolder folder;
  std::string observations; ///< folder
  FrameRectifier rectifier;
  ShotGroups groups;
  std::optional<LiveMap> map;
  bool is_finishing = false; ///< all observations are there
  bool is_finished = false;
};

/** \brief All outputs of a run. Session and clouds are consistent: an observation is
 * recorded when it is complete, and then its cloud is computed. */
class GrabOutputs {
public:
  /** \param[in] live shows each cloud; may be null
   * \throws OutputFileException when a folder cannot be written to, or holds results
   * \throws InputFileException when the rig cannot be matched or rectified
   * \throws MemoryLimitException */
  GrabOutputs(const GrabberOptions& options,
              const Device& device,
              unsigned threads,
              LiveWindow* live,
              StageLog& log)
  : options_(options)
  , live_(live)
  , log_(log)
  {
    if (!options.map.output.empty()) {
      map_.emplace(options, device, threads, live);
      log_.warn(map_->rectifier.remarks());
    }
    else if (!options.clouds.empty() || (options.live && !options.isStream())) {
      clouds_.emplace(options, device, threads);
      log_.warn(clouds_->rectifier.remarks());
    }
    if (!options.session.empty())
      recorder_.emplace(options.session, device.rig, device.cameras);
  }

  ~GrabOutputs()
  {
    if (recorder_)
      recorder_->discardIfEmpty();
  }

  GrabOutputs(const GrabOutputs&) = delete;
  GrabOutputs&
  operator=(const GrabOutputs&) = delete;

  /** \brief Adds a frame; the first frame of another observation closes the one
   * before. */
  void
  take(const TrinocularFrame::ConstPtr& frame, const ProgressCallback& progress)
  {
    if (isNext(*frame))
      close(progress);
    open_.push_back(frame);
  }

  /** \brief Closes the observation: records its frames, and computes its cloud.
   * \throws OutputFileException, CancelledException */
  void
  close(const ProgressCallback& progress)
  {
    if (open_.empty())
      return;
    const std::vector<TrinocularFrame::ConstPtr> frames = std::exchange(open_, {});
    Report steps;
    StepTimer timer(steps);
    if (recorder_)
      for (const TrinocularFrame::ConstPtr& frame : frames)
        recorder_->record(*frame);
    timer.finish("record");
    if (clouds_) {
      makeCloud(frames, progress);
      timer.finish("match");
    }
    if (map_) {
      if (const auto shots = shotsOf(frames, map_->rectifier, map_->groups))
        map_->map->add(shots->frames);
      timer.finish("map");
    }
    for (const auto& [step, seconds] : steps.seconds)
      seconds_[step] += seconds;
    ++observations_;
  }

  /** \brief Shows what is new of the map. */
  void
  show()
  {
    if (map_)
      map_->map->show();
  }

  /** \brief Number of closed observations. */
  std::size_t
  observations() const
  {
    return observations_;
  }

  /** \brief Does a frame begin another observation than the current one? */
  bool
  isNext(const TrinocularFrame& frame) const
  {
    return !open_.empty() && open_.front()->observation != frame.observation;
  }

  /** \brief Sets the bytes of the recorded frames, if there is a session, and the free
   * bytes on the disk of the outputs. */
  void
  measure(GrabStatus& status) const
  {
    if (recorder_)
      status.written = recorder_->bytes();
    std::error_code error;
    const std::string& place = recorder_ ? options_.session
                               : map_    ? options_.map.output
                                         : options_.clouds;
    const fs::space_info space = fs::space(place, error);
    if (!place.empty() && !error)
      status.free = space.available;
  }

  /** \brief Completes the outputs and moves them to their final place.
   * \throws NothingFound when there is no point in any cloud; the session is kept */
  void
  finish(const RunControls& controls)
  {
    if (recorder_)
      recorder_->finish();
    if (clouds_ && clouds_->converted.report.points == 0) {
      warnOfRemarks(clouds_->converted, log_);
      log_.failWithNothing(noPlaceText(clouds_->converted));
    }
    if (clouds_ && clouds_->folder)
      clouds_->folder->commit();
    if (map_) {
      map_->is_finishing = true;
      map_->map->finish(PicturesApart(false, log_), map_->folder, controls, log_);
      map_->is_finished = true;
      if (const auto missing = map_->map->missing())
        missing->fail(map_->settings.output);
    }
  }

  /** \brief Keeps complete outputs after an error, and rethrows it with a note about
   * what was kept. */
  [[noreturn]] void
  keep(const std::exception_ptr& error, const RunControls& controls)
  {
    const Failure failure = failureOf(error);
    const std::string kept = keepClouds() + keepSession() + keepMap(failure, controls);
    if (kept.empty())
      std::rethrow_exception(error);
    throw FailedPartway(
        failure.code,
        (failure.code == exit_interrupted ? "interrupted" : failure.line) + kept);
  }

  /** \brief Writes lines of the summary and the report. */
  void
  tell() const
  {
    Json& details = log_.details;
    if (clouds_)
      log_.warn(clouds_->groups.remarks());
    if (map_)
      log_.warn(map_->groups.remarks());
    log_.tell("observations", std::to_string(observations_));
    if (clouds_) {
      const ConvertedSession& converted = clouds_->converted;
      warnOfRemarks(converted, log_);
      details["method"] = options_.map.stereo.method;
      details["least_disparity"] = clouds_->fusion.range().minimum;
      details["most_disparity"] = clouds_->fusion.range().maximum();
      details["points"] = converted.report.points;
      details["matched_share"] = converted.matchedShare();
      details["observations"] = Json::parse(converted.figuresText());
      tellPoints(converted, log_);
    }
    for (const auto& [step, seconds] : seconds_)
      log_.report.seconds.emplace_back(step, seconds);
    details["clouds"] = options_.clouds;
    details["map"] = options_.map.output;
    details["session"] = options_.session;
    if (recorder_) {
      details["recorded_frames"] = recorder_->frames();
      details["recorded_bytes"] = recorder_->bytes();
    }
  }

private:
  void
  makeCloud(const std::vector<TrinocularFrame::ConstPtr>& frames,
            const ProgressCallback& progress)
  {
    const auto shots = shotsOf(frames, clouds_->rectifier, clouds_->groups);
    if (!shots)
      return;
    const SessionObservation made = clouds_->fusion.fuse(*shots, progress);
    if (clouds_->folder) {
      PCLPointCloud2 cloud;
      toPCLPointCloud2(made.cloud, cloud);
      saveObservation(clouds_->folder->path(observationName(made.number)),
                      cloud,
                      Eigen::Isometry3d::Identity());
    }
    clouds_->converted.add(made);
    if (live_)
      live_->show(made.cloud);
  }

  std::string
  keepClouds()
  {
    if (!clouds_ || !clouds_->folder || clouds_->converted.report.points == 0)
      return "";
    clouds_->folder->commit();
    return "; observations finished by then, in " + options_.clouds + ": " +
           std::to_string(clouds_->converted.report.observations);
  }

  std::string
  keepSession()
  {
    if (!recorder_ || recorder_->frames() == 0)
      return "";
    try {
      recorder_->finish();
    }
    catch (const OutputFileException&) {
      // frames can be read without it, and the earlier error is reported
    }
    return "; frames recorded by then, in " + options_.session + ": " +
           std::to_string(recorder_->frames());
  }

  /** Makes the map of the observations so far; if it was being made, or that fails, they
   * are kept. */
  std::string
  keepMap(const Failure& failure, const RunControls& controls)
  {
    if (!map_ || map_->is_finished || map_->map->observations() == 0)
      return "";
    std::string why;
    if (!map_->is_finishing) {
      if (failure.code == exit_interrupted)
        forgetInterruption();
      else
        map_->map->keepProcessed(failure.line);
      try {
        map_->map->finish(PicturesApart(false, log_), map_->folder, controls, log_);
        return "; " + partialMapText(map_->map->observations(), map_->settings.output);
      }
      catch (const std::exception&) {
        const Failure fault = failureOf(std::current_exception());
        why = "; there is no map of them: " + fault.line;
      }
    }
    const std::size_t kept = map_->map->processed();
    if (kept == 0)
      return why;
    map_->map->keep();
    return "; observations finished by then, in " + map_->observations + ": " +
           std::to_string(kept) + why;
  }

  const GrabberOptions& options_;
  LiveWindow* const live_;
  StageLog& log_;
  std::optional<MapOutput> map_;
  std::optional<CloudOutput> clouds_;
  std::optional<TrinocularRecorder> recorder_;  // of the raw session
  std::vector<TrinocularFrame::ConstPtr> open_; // frames of the current observation
  std::size_t observations_ = 0;
  // seconds of each step, summed over all observations
  std::map<std::string, double> seconds_;
};

void
tellRecording(const GrabberOptions& options,
              const TrinocularFileReport& report,
              StageLog& log)
{
  warnOfFindings(log, report.remarks);
  if (!report.doubled.empty())
    log.warn(std::to_string(report.doubled.size()) +
             " frames whose shot was there before are left out");
  Json& details = log.details["recording"];
  details = {{"folder", options.recording()}};
  details.update(fieldsOf(report, {{"frames"}, {"missing"}, {"saturated"}, {"black"}}));
  details["findings"] = report.remarks;
  log.tell("recording", options.recording());
}

void
tellProjector(const GrabberOptions& options,
              const Projection& projection,
              StageLog& log)
{
  const MonitorPlace& monitor = projection.monitor;
  const PatternSequenceGrabberReport report = projection.sequence->getReport();
  const double settle = projection.sequence->getSettleTime();
  log.warn(report.remarks);
  log.details["projector"] = {{"monitor", monitor.name},
                              {"width", monitor.width},
                              {"height", monitor.height},
                              {"patterns", options.pattern.patterns},
                              {"seed", options.pattern.generator.getSeed()},
                              {"settle", settle},
                              {"spared", report.spared}};
  log.tell("projector",
           "monitor " + monitor.name + ", " + sizeText(monitor) + " px, settles in " +
               shortNumber(settle) + " s" +
               (options.early
                    ? ", " + std::to_string(report.spared) + " patterns spared"
                    : ""));
}

/** \brief Moves frames from the device to the outputs. */
class GrabRun {
public:
  /** \brief Opens device, outputs, projector and window. */
  GrabRun(const GrabberOptions& options,
          const GrabbedCameraOpener& opener,
          const RunControls& controls,
          StageLog& log)
  : options_(options)
  , controls_(controls)
  , log_(log)
  , live_(options.live ? std::make_unique<LiveWindow>(drawing_, options.tool) : nullptr)
  , status_(options.tool, !controls.is_quiet)
  , device_(openDevice(options, opener, log))
  , outputs_(options, device_, controls.threads, live_.get(), log)
  , wanted_(options.observations.value_or(device_.recording ? 0 : 1))
  {
    if (device_.camera && !options.isStream())
      projection_ = openProjection(options, device_, drawing_, status_, log);
  }

  GrabRun(const GrabRun&) = delete;
  GrabRun&
  operator=(const GrabRun&) = delete;

  /** \brief Does the work, and keeps complete outputs if it fails.
   * \param[in] timer at the begin of the work */
  void
  run(StepTimer& timer)
  {
    try {
      if (projection_)
        passObservations(*projection_->sequence);
      else if (device_.camera)
        passStream();
      else
        passRecording();
      timer.finish("grab");
      outputs_.finish(mapControls());
    }
    catch (...) {
      outputs_.keep(std::current_exception(), mapControls());
    }
  }

  /** \brief Writes summary and report. */
  void
  tell()
  {
    if (device_.camera)
      device_.camera->tell(log_);
    else
      tellRecording(options_, device_.recording->getReport(), log_);
    if (projection_)
      tellProjector(options_, *projection_, log_);
    log_.details["frames"] = frames();
    log_.details["is_rectified"] = !device_.cameras.has_value();
    log_.tell("frames",
              std::to_string(frames()) + (device_.cameras ? ", raw" : ", rectified"));
    outputs_.tell();
  }

  /** \brief After the work: shows the window until it is closed, or until an
   * interruption. */
  void
  waitForWindow()
  {
    if (!live_ || live_->isClosed() || interrupted())
      return;
    status_.note("done; close the window to end");
    while (!live_->isClosed() && !interrupted()) {
      live_->update();
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }

private:
  /** Processes all observations of a recording, or the requested number. */
  void
  passRecording()
  {
    const std::vector<std::uint64_t> doubled = device_.recording->getReport().doubled;
    stream_.emplace(*device_.recording);
    device_.recording->start();
    pumpAll([&](const TrinocularFrame::ConstPtr& frame) {
      if (std::count(doubled.begin(), doubled.end(), frame->number) > 0)
        return true;
      const bool is_next = outputs_.isNext(*frame);
      if (is_next && outputs_.observations() + 1 == wanted_)
        return false;
      shots_ = is_next ? 1 : shots_ + 1;
      outputs_.take(frame, progress());
      return true;
    });
    outputs_.close(progress());
    if (frames() == 0)
      throw InputFileException(options_.recording() +
                               ": has no frame that can be read");
  }

  /** Processes frames of the camera, one after another, until the user ends
   * it. */
  void
  passStream()
  {
    const bool has_end = options_.frames > 0 || options_.seconds > 0;
    stream_.emplace(*device_.camera->grabber());
    device_.camera->grabber()->start();
    const Clock::time_point begin = Clock::now();
    const auto use = [&](const TrinocularFrame::ConstPtr& frame) {
      outputs_.take(frame, progress());
      outputs_.close(progress());
      return frames() != options_.frames;
    };
    pump(use, [&] {
      if (has_end)
        stopIfInterrupted();
      const std::chrono::duration<double> passed = Clock::now() - begin;
      const bool is_for_window = options_.session.empty();
      return interrupted() || (is_for_window && live_->isClosed()) ||
             (options_.seconds > 0 && passed.count() >= options_.seconds);
    });
  }

  /** Processes observations of camera and projector. */
  void
  passObservations(PatternSequenceGrabber& sequence)
  {
    if (options_.early) {
      need_.emplace(rectifierOf(options_, device_, controls_.threads));
      sequence.setWantMore([this](const TrinocularFrame& frame) {
        return need_->wantsMoreAfter(frame);
      });
    }
    stream_.emplace(sequence);
    Pacing pacing(options_.every);
    for (std::size_t i = 0; i < wanted_; ++i) {
      const auto wait = [&] {
        stopIfInterrupted();
        idle();
      };
      if (i > 0 && pacing.asks())
        status_.note("Enter takes observation " + std::to_string(i) + " of " +
                     std::to_string(wanted_) + ", q and Enter ends");
      if (i > 0 && !pacing.wait(wait))
        break;
      pacing.begin();
      shots_ = 0;
      sequence.observe();
      pumpAll([&](const TrinocularFrame::ConstPtr& frame) {
        ++shots_;
        outputs_.take(frame, progress());
        return true;
      });
      outputs_.close(progress());
    }
  }

  std::size_t
  frames() const
  {
    return stream_ ? stream_->frames() : 0;
  }

  /** Processes frames until the stream is over. */
  void
  pump(const FrameStream::UseFrame& use, const FrameStream::IsOver& is_over)
  {
    stream_->pass(
        [&](const TrinocularFrame::ConstPtr& frame) {
          if (live_)
            live_->show(*frame);
          return use(frame);
        },
        [&] {
          const bool ends = is_over();
          idle();
          return ends;
        });
  }

  /** Likewise; only an error or the user ends the stream early. */
  void
  pumpAll(const FrameStream::UseFrame& use)
  {
    pump(use, [] {
      stopIfInterrupted();
      return false;
    });
  }

  void
  idle()
  {
    update(options_.isStream()
               ? ""
               : "observation " + std::to_string(outputs_.observations()) + ", shot " +
                     std::to_string(shots_));
  }

  /** \brief Those of the map after the last observation. */
  RunControls
  mapControls()
  {
    RunControls controls = controls_;
    controls.progress = progress();
    return controls;
  }

  ProgressCallback
  progress()
  {
    return [this](double, const std::string& step) {
      update(step);
      return !interrupted();
    };
  }

  /** Updates the window and the status line. */
  void
  update(const std::string& doing)
  {
    outputs_.show();
    if (live_)
      live_->update();
    if (!status_.isDue())
      return;
    GrabStatus now;
    now.frames = frames();
    now.doing = doing;
    outputs_.measure(now);
    if (device_.camera)
      device_.camera->count(now);
    else
      now.broken = device_.recording->getReport().broken.size();
    status_.show(statusText(now));
  }

  const GrabberOptions& options_;
  const RunControls& controls_;
  StageLog& log_;
  // locks the drawing of the projector's window and of the live window
  std::mutex drawing_;
  std::unique_ptr<LiveWindow> live_; // null if it is not wanted
  StatusLine status_;
  const Device device_;
  GrabOutputs outputs_;
  std::optional<Projection> projection_;
  std::optional<PatternNeed> need_;   // set if observations may end early
  std::optional<FrameStream> stream_; // its end is that of all callbacks
  std::size_t shots_ = 0;             // of the current observation
  std::size_t wanted_ = 0;            // number of observations, 0: all
};

} // namespace

void
grab(const GrabberOptions& options,
     const GrabbedCameraOpener& opener,
     const RunControls& controls,
     StageLog& log)
{
  StepTimer timer(log.report);
  GrabRun run(options, opener, controls, log);
  timer.finish("open");
  run.run(timer);
  run.tell();
  run.waitForWindow();
}

} // namespace pcl::acmap
