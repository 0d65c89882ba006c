#include "stereo_observation.h"

#include "memory.h"
#include "output_target.h"

#include <pcl/conversions.h>
#include <pcl/core/fields_json.h>
#include <pcl/core/impl/folder_entries.h>
#include <pcl/core/rig_cameras.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_writing.h>

#include <filesystem>
#include <memory>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/** \brief Name of the file that lists the finished observations, from which a later run
 * can continue. */
constexpr const char* finished_name = "finished.json";

std::shared_ptr<const FrameReader>
openFrames(const StereoOptions& options, const std::optional<CalibratedRig>& rig)
{
  if (rig)
    return std::make_shared<TrinocularFileGrabber>(options.images, rig->rig);
  return std::make_shared<TrinocularFileGrabber>(options.session);
}

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
  , rig_(options.hasLists() ? std::optional(options.rigOfLists()) : std::nullopt)
  , frames_(openFrames(options, rig_))
  , session_(withDepths([&] {
    SessionSettings settings = options.sessionSettings(controls.threads);
    if (rig_)
      settings.cameras = rig_->cameras;
    return openSession(frames_, settings, memoryCheck());
  }))
  {
    if (!options.poses.empty()) {
      poses_ = loadTrajectory(options.poses);
      if (session_->size() > 0)
        poseOf(session_->numberOf(session_->size() - 1));
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
  writeAll(const ProgressCallback& progress, Report& report)
  {
    Report steps;
    StepTimer timer(steps);
    const auto count = static_cast<double>(session_->size());
    SessionObservation made;
    const auto make = [&](std::size_t i) -> std::optional<ObservationToWrite> {
      const std::optional<ObservationShots> shots = session_->nextShots();
      timer.finish("wait for shots");
      if (!shots || results_.has(shots->number))
        return {};
      made = session_->fuse(*shots, [&](double fraction, const std::string& step) {
        return progress((static_cast<double>(i) + fraction) / count, step);
      });
      timer.finish("match");
      results_.add(made);
      PCLPointCloud2::Ptr cloud(new PCLPointCloud2);
      toPCLPointCloud2(made.cloud, *cloud);
      return {{cloud, poseOf(made.number), 0, observationName(made.number)}};
    };
    std::optional<OutputFolder> part;
    OutputFolder& folder = options_.goes_on ? part.emplace(options_.output) : *folder_;
    const auto finish = [&](const ObservationToWrite&) {
      saveDisparity(folder, options_, made);
      if (part)
        commit(part);
      timer.finish("write");
    };
    writeObservations(
        folder, session_->size(), make, {progress, "reading shots", finish});
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
                             std::to_string(results_.observations));
  }

  /** \brief Moves the results to their final place.
   * \throws InputFileException when there was no readable frame
   * \throws NothingFound when no observation has a point */
  void
  finish(StageLog& log)
  {
    warn(log);
    if (results_.observations == 0)
      throw InputFileException(
          options_.session +
          (options_.settings.unlit
               ? ": has no shot without projected light that can be read"
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
    const SearchRange& range = session_->range();
    // it is above the requested one if image or matcher limit the disparities
    const DisparityBackProjection& depths = options_.settings.projection;
    const double nearest =
        std::max(depths.getMinimumDepth(), depthOf(session_->rig(), range.maximum()));
    // with an offset, disparities below 0 would be farther away
    const double farthest = disparityOffset(session_->rig()) > 0.0
                                ? std::min(depths.getMaximumDepth(),
                                           depthOf(session_->rig(), range.minimum))
                                : depths.getMaximumDepth();
    log.details = {
        {"input", options_.hasLists() ? options_.rigPath() : options_.session},
        {"output", options_.output},
        {"calibration", rig_ ? Json(rig_->told) : Json()},
        {"rig",
         {{"width", session_->rig().width},
          {"height", session_->rig().height},
          {"focal_length", session_->rig().focal_length},
          {"baseline_horizontal", session_->rig().baseline_horizontal},
          {"baseline_vertical", session_->rig().baseline_vertical}}},
        {"frames", session_->isRectifying() ? "raw" : "rectified"},
        {"method", options_.isPassive() ? "passive" : options_.method},
        {"least_disparity", range.minimum},
        {"most_disparity", range.maximum()},
        {"least_depth", nearest},
        {"most_depth", farthest},
        {"has_poses", !options_.poses.empty()},
        {"points", results_.points},
        {"matched_share", results_.matchedShare()},
        {"outcomes",
         FieldValueJson()(Named{results_.outcomes, disparity_outcome_names})},
        {"broken_frames", frames_->faults().broken},
        {"findings", session_->remarks()},
        {"observations", results_.entries}};
    if (rig_)
      log.tell("rig", rig_->told);
    log.tell("observations", std::to_string(results_.observations));
    log.tell("frames",
             std::to_string(results_.frames) + (session_->isRectifying()
                                                    ? ", rectified here"
                                                    : ", taken as rectified"));
    log.tell("method", methodText());
    log.tell("searched",
             std::to_string(range.minimum) + " to " + std::to_string(range.maximum()) +
                 " px, depths of " + shortNumber(nearest) + " to " +
                 shortNumber(farthest) + " m");
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

  /** Moves an observation to its final place, with the statistics so far, from which a
   * later run is to continue: a run that is killed loses only the observation that it was
   * working on. The next one is written at the same place. */
  void
  commit(std::optional<OutputFolder>& part) const
  {
    saveJson(part->path(finished_name), results_.entries, -1);
    part->commit();
    part.emplace(options_.output);
  }

  void
  warn(StageLog& log) const
  {
    warnOfFindings(log, session_->remarks());
    results_.warnOfRemarks(log);
    if (rig_ && rig_->leaves_built_out)
      log.warn("images are taken as rectified; if they are as the cameras in " +
               options_.rigPath() + " gave them, they need --rectify");
  }

  /** How the shots were matched. With one image per camera, which the user may have
   * taken with or without a pattern, the other possibility is named too. */
  std::string
  methodText() const
  {
    if (options_.settings.unlit)
      return "passive stereo, shots without projected light";
    if (!options_.hasOneShot())
      return options_.method;
    return options_.isPassive() ? "passive stereo, one image per camera "
                                  "(--active: taken under a pattern)"
                                : "one shot under a pattern (--active)";
  }

  const StereoOptions& options_;
  const std::optional<CalibratedRig> rig_; ///< of image lists
  std::shared_ptr<const FrameReader> frames_;
  std::shared_ptr<SessionSource> session_;
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
    run.writeAll(controls.progress, log.report);
  }
  catch (const CancelledException&) {
    run.keepFinished();
    throw;
  }
  run.finish(log);
  run.tell(log);
}

} // namespace pcl::acmap
