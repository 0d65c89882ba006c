#include "shot_source.h"
#include "stereo_observation.h"

#include "fields_json.h"
#include "memory.h"
#include "output_target.h"

#include <pcl/core/rig_cameras.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/observation_files.h>

#include <filesystem>
#include <future>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/** \brief Name of the file that lists the finished observations, from which a later run
 * can continue. */
constexpr const char* finished_name = "finished.json";

StereoResults
finishedBefore(const StereoOptions& options)
{
  const fs::path folder = options.output;
  const Json entries = readJson((folder / finished_name).string());
  if (!options.goes_on || !entries.is_array())
    return {};
  try {
    StereoResults results;
    for (const Json& entry : entries) {
      const auto name = entry.at("file").get<std::string>();
      if (isPlainName(name) && fs::exists(folder / name))
        results.add(entry);
    }
    return results;
  }
  catch (const nlohmann::json::exception&) {
    return {}; // damaged: everything is computed again
  }
}

/** \brief The complete work of pcl_active_stereo. */
class StereoRun {
public:
  StereoRun(const StereoOptions& options, const RunControls& controls)
  : options_(options)
  , source_(options, controls.threads)
  , fusion_(source_.rig(), options, controls.threads)
  {
    if (!options.poses.empty()) {
      poses_ = loadTrajectory(options.poses);
      poseOf(source_.lastObservation());
    }
    folder_.emplace(options.output);
    if (!options.goes_on)
      requireNoStereo(*folder_);
    if (!options.poses.empty())
      saveTrajectory(folder_->path(trajectory_name), poses_);
    results_ = finishedBefore(options);
  }

  /** \brief Computes the observations one after another, while the next one is read.
   * Seconds of each step are summed over the observations. */
  void
  writeObservations(const ProgressCallback& progress, Report& report)
  {
    Report steps;
    StepTimer timer(steps);
    const Progress told(
        [&](double done, const auto& step) { return progress(done, step); });
    const auto read_on = [&] {
      return std::async(std::launch::async, [&] { return source_.next(); });
    };
    double begin = 0;
    for (std::future<ComingShots> next = read_on();;) {
      told.tell(begin, "reading shots");
      const auto [shots, done] = next.get();
      timer.finish("wait for shots");
      if (!shots)
        break;
      next = read_on();
      if (!results_.has(shots->number)) {
        const MadeObservation made = fusion_.make(
            *shots, [&, end = done](double fraction, const std::string& step) {
              return progress(std::min(begin + fraction * (end - begin), end), step);
            });
        timer.finish("match");
        results_.add(shots->number, shots->frames.size(), made);
        save(shots->number, made);
        timer.finish("write");
      }
      begin = done;
    }
    for (const char* const step : {"wait for shots", "match", "write"}) {
      double sum = 0;
      for (const auto& [name, seconds] : steps.seconds)
        sum += name == step ? seconds : 0;
      report.seconds.emplace_back(step, sum);
    }
  }

  /** \brief Keeps the observations that were finished before an interruption; each of
   * them is complete.
   * \throws InterruptedPartway when there is any */
  void
  keepFinished()
  {
    if (results_.points == 0)
      return;
    folder_->commit();
    throw InterruptedPartway("interrupted; observations finished by then, in " +
                             options_.output + ": " +
                             std::to_string(results_.observations.size()));
  }

  /** \brief Moves the results to their final place.
   * \throws InputFileException when there was no readable frame
   * \throws NothingFound when no observation has a point */
  void
  finish(StageLog& log)
  {
    warn(log);
    if (results_.observations.empty())
      throw InputFileException(
          options_.session +
          (options_.unlit ? ": has no shot without projected light that can be read"
                          : ": has no frame that can be read") +
          (log.report.remarks.empty() ? "" : ", " + log.report.remarks[0]));
    if (results_.points == 0)
      log.failWithNothing((options_.session.empty() ? "" : options_.session + ": ") +
                          "no pixel has a place: " + results_.rejected());
    folder_->commit();
    std::error_code ignored;
    fs::remove(fs::path(options_.output) / finished_name, ignored);
  }

  /** \brief Writes summary and report. */
  void
  tell(StageLog& log) const
  {
    const SearchRange& range = fusion_.range();
    // it is above the requested one if image or matcher limit the disparities
    const double nearest = std::max(options_.projection.getMinimumDepth(),
                                    depthOf(source_.rig(), range.maximum()));
    log.details = {
        {"input", options_.hasLists() ? options_.rig : options_.session},
        {"output", options_.output},
        {"frames", source_.isRectifying() ? "raw" : "rectified"},
        {"method", options_.isPassive() ? "passive" : options_.method},
        {"least_disparity", range.minimum},
        {"most_disparity", range.maximum()},
        {"least_depth", nearest},
        {"most_depth", options_.projection.getMaximumDepth()},
        {"has_poses", !options_.poses.empty()},
        {"points", results_.points},
        {"matched_share", results_.matchedShare()},
        {"outcomes",
         FieldValueJson()(Named{results_.outcomes, disparity_outcome_names})},
        {"broken_frames", source_.broken()},
        {"findings", source_.remarks()},
        {"observations", results_.observations}};
    log.tell("observations", std::to_string(results_.observations.size()));
    log.tell("frames",
             std::to_string(results_.frames) + (source_.isRectifying()
                                                    ? ", rectified here"
                                                    : ", taken as rectified"));
    log.tell("method", methodText());
    log.tell("searched",
             std::to_string(range.minimum) + " to " + std::to_string(range.maximum()) +
                 " px, depths of " + shortNumber(nearest) + " to " +
                 shortNumber(options_.projection.getMaximumDepth()) + " m");
    results_.tellPoints(log);
    if (!options_.hasLists())
      log.tell("poses", options_.poses.empty() ? "none" : options_.poses);
    log.tellSeconds();
    log.tell("folder", options_.output);
  }

private:
  /** T_map_camera of an observation; the identity if no poses are given.
   * \throws InputFileException when there is none for it */
  Eigen::Isometry3d
  poseOf(std::size_t observation) const
  {
    if (options_.poses.empty())
      return Eigen::Isometry3d::Identity();
    if (observation >= poses_.poses.size())
      throw InputFileException(options_.poses + ": has " +
                               std::to_string(poses_.poses.size()) +
                               " poses, none for observation " +
                               std::to_string(observation) + " (counted from 0)");
    return poses_.poses[observation];
  }

  /** Writes an observation into the hidden part of the folder. If a later run is to
   * continue from it, it is moved to its final place, with the statistics so far: a run
   * that is killed loses only the observation that it was working on. */
  void
  save(std::size_t number, const MadeObservation& made) const
  {
    if (!options_.goes_on)
      return saveResults(*folder_, options_, number, made, poseOf(number));
    OutputFolder finished(options_.output);
    saveResults(finished, options_, number, made, poseOf(number));
    saveJson(finished.path(finished_name), results_.observations, -1);
    finished.commit();
  }

  void
  warn(StageLog& log) const
  {
    warnOfFindings(log, source_.remarks());
    results_.warnOfRemarks(log);
    if (source_.mayNeedRectification())
      log.warn("images are taken as rectified; if they are as the cameras in " +
               options_.rig + " gave them, they need --rectify");
  }

  /** How the shots were matched. With one image per camera, which the user may have
   * taken with or without a pattern, the other possibility is named too. */
  std::string
  methodText() const
  {
    if (options_.unlit)
      return "passive stereo, shots without projected light";
    if (!options_.hasOneShot())
      return options_.method;
    return options_.isPassive() ? "passive stereo, one image per camera "
                                  "(--active: taken under a pattern)"
                                : "one shot under a pattern (--active)";
  }

  const StereoOptions& options_;
  ShotSource source_;
  ShotFusion fusion_;
  Trajectory poses_;
  std::optional<OutputFolder> folder_;
  StereoResults results_;
};

} // namespace

void
makeObservations(const StereoOptions& options,
                 const RunControls& controls,
                 StageLog& log)
{
  StepTimer timer(log.report);
  StereoRun run(options, controls);
  timer.finish("open");
  try {
    run.writeObservations(controls.progress, log.report);
  }
  catch (const CancelledException&) {
    run.keepFinished();
    throw;
  }
  run.finish(log);
  run.tell(log);
}

} // namespace pcl::acmap
