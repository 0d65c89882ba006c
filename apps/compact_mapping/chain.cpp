#include "chain.h"

#include "active_stereo/stereo_options.h"
#include "entropy_rectification/pose_adjustment.h"
#include "entropy_rectification/rectification_options.h"
#include "fields_json.h"
#include "recording.h"
#include "visual_egomotion/egomotion_options.h"

#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_list.h>
#include <pcl/pipeline/sequence_alignment.h>

#include <algorithm>
#include <filesystem>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/** \brief The properties of the input by which stages detect a change. */
Json
sequenceState(const std::string& folder)
{
  std::vector<std::string> names = observationNames(folder);
  names.emplace_back(trajectory_name);
  return stateOf(folder, names);
}

} // namespace

void
tellExtension(const SequenceAlignmentReport& report, StageLog& log)
{
  log.details["proposals"] = report.revisits.proposals;
  log.details.update(fieldsOf(report, {{"revisits"}}));
  log.tell("joined",
           "at " + std::to_string(report.agreeing) + " of " +
               std::to_string(report.places) + " places that both maps have seen");
}

Chain::Chain(const ChainOptions& options,
             ValuesOfGroup values,
             RunControls controls,
             StageLog& log,
             std::string folder)
: options_(options)
, values_(std::move(values))
, controls_(std::move(controls))
, log_(log)
, folder_(std::move(folder))
{}

std::string
Chain::folderOf(const std::string& stage) const
{
  return (fs::path(folder_) / stage).string();
}

/** Adds what all stages are made of. */
void
Chain::addState(Json& made_of) const
{
  if (options_.planes.paper)
    made_of["mode"] = "paper";
  made_of["stages_before"] = made_of_;
}

bool
Chain::isFinished(const std::string& name,
                  Json made_of,
                  const std::string& result_folder) const
{
  addState(made_of);
  return StageFolder(folderOf(name), made_of, result_folder).finished().has_value();
}

const StageLog&
Chain::run(const std::string& name,
           Json made_of,
           const std::function<std::vector<std::string>(StageLog&)>& work,
           const std::string& result_folder)
{
  addState(made_of);
  const StageFolder folder(folderOf(name), made_of, result_folder);
  made_of_ = fingerprint(made_of);
  if (std::optional<StageLog> told = folder.finished()) {
    stages_.push_back({name, std::move(*told), true, {}});
    return stages_.back().told;
  }
  folder.begin();
  std::vector<std::string> results;
  StageLog told;
  try {
    results = work(told);
  }
  catch (const InterruptedPartway&) {
    throwInterrupted(name + " in part");
  }
  catch (const CancelledException&) {
    folder.abandon();
    if (stages_.empty())
      throw;
    throwInterrupted("");
  }
  catch (...) {
    log_.warn(told.report.remarks); // they often explain the failure
    folder.abandon();
    throw;
  }
  forgetWhatWasTold(told);
  std::vector<std::string> removed =
      results.empty() ? folder.finish(told) : folder.finish(told, results);
  stages_.push_back({name, std::move(told), false, std::move(removed)});
  return stages_.back().told;
}

/** A broken observation is told once, by the stage that reads it first. */
void
Chain::forgetWhatWasTold(StageLog& log) const
{
  std::vector<std::string>& remarks = log.report.remarks;
  const auto is_told = [&](const std::string& remark) {
    return std::any_of(stages_.begin(), stages_.end(), [&](const RunStage& stage) {
      const std::vector<std::string>& told = stage.told.report.remarks;
      return std::find(told.begin(), told.end(), remark) != told.end();
    });
  };
  remarks.erase(std::remove_if(remarks.begin(), remarks.end(), is_told), remarks.end());
}

void
Chain::throwInterrupted(std::string last) const
{
  std::string finished = last;
  for (auto stage = stages_.rbegin(); stage != stages_.rend(); ++stage)
    finished = stage->name + (finished.empty() ? "" : ", ") + finished;
  throw InterruptedPartway("interrupted; finished by then, and kept in " + folder_ +
                           " for the next run: " + finished);
}

Sequence
Chain::sequenceFrom(StartingPoint start,
                    const std::optional<ObservationSequence>& recorded)
{
  const bool is_session = start == StartingPoint::Session;
  const double scale = is_session ? 1 : controls_.scale;
  const std::string observations = is_session ? makeObservations()
                                   : recorded ? importObservations(*recorded)
                                              : options_.input;
  Sequence sequence;
  const bool is_posed =
      start == StartingPoint::PosedObservations || !options_.stereo.poses.empty();
  if (is_posed || observationNames(observations).size() < 2)
    sequence.posed.emplace(observations, scale);
  else
    sequence.posed = findPoses(observations, scale);
  if (recorded)
    sequence.posed = sequence.posed->withShift(scale * recorded->shift());
  const auto& rectification = options_.rectification.stage;
  OdometryNoise noise = rectification.getOdometryNoise();
  if (poses_.noise && !rectification.hasOdometryNoise())
    noise = *poses_.noise;
  if (!options_.earlier.empty())
    sequence.posed = extend(*sequence.posed);
  const bool has_several = sequence.posed->size() > 1;
  sequence.is_rectified = options_.rectifies && has_several;
  if (sequence.is_rectified)
    sequence.posed = rectify(observations, *sequence.posed, noise, scale);
  if (options_.egomotion.isRigid() && has_several)
    sequence.posed =
        adjust(observations, *sequence.posed, sequence.is_rectified, noise, scale);
  sequence.up = poses_.up;
  return sequence;
}

std::string
Chain::makeObservations()
{
  StereoOptions stereo = options_.stereo;
  stereo.session = options_.input;
  stereo.output = folderOf("observations");
  stereo.goes_on = true;
  Json made_of = {{"files", stateOf(options_.input, filesIn(options_.input))},
                  {"options", values_(stereo_group)}};
  if (!stereo.poses.empty())
    made_of["poses"] = stateOfFile(stereo.poses);
  run("observations", made_of, [&](StageLog& log) {
    acmap::makeObservations(stereo, controls_, log);
    return std::vector<std::string>();
  });
  return stereo.output;
}

std::string
Chain::importObservations(const ObservationSequence& recorded)
{
  std::string folder = folderOf("observations");
  run("observations",
      {{"file", stateOfFile(options_.input)}, {"options", values_(bag_group)}},
      [&](StageLog& log) {
        importRecording(options_.input, recorded, folder, controls_, log);
        return std::vector<std::string>();
      });
  return folder;
}

ObservationSequence
Chain::findPoses(const std::string& observations, double scale)
{
  const ObservationSequence sequence(observationPaths(observations), scale);
  EgomotionOptions egomotion = options_.egomotion;
  egomotion.inputs = {observations};
  egomotion.output = folderOf("egomotion");
  egomotion.writes_observations = false;
  return runPoses("egomotion",
                  {{"files", sequenceState(observations)},
                   {"scale", scale},
                   {"options", values_(egomotion_group)},
                   {"motion", values_(motion_group)}},
                  sequence,
                  [&](StageLog& log) {
                    return estimatePoses(egomotion, sequence, controls_, log);
                  });
}

ObservationSequence
Chain::extend(const ObservationSequence& posed)
{
  const ObservationSequence earlier = openMappedObservations(options_.earlier);
  const ObservationSequence joined = earlier.followedBy(posed);
  return runPoses(
      "extension",
      {{"observations", joined.fingerprint()}, {"motion", values_(motion_group)}},
      joined,
      [&](StageLog& log) {
        StepTimer timer(log.report);
        SequenceAlignment alignment;
        alignment.setInputTarget(earlier);
        alignment.setMotionModel(options_.egomotion.stage.getMotionModel());
        alignment.setNumberOfThreads(controls_.threads);
        alignment.setProgressCallback(controls_.progress);
        EstimatedPoses poses =
            extendedPoses(joined, earlier.size(), alignment, poses_.noise);
        tellExtension(alignment.getReport(), log);
        timer.finish("align");
        return poses;
      });
}

ObservationSequence
Chain::rectify(const std::string& observations,
               const ObservationSequence& posed,
               const OdometryNoise& noise,
               double scale)
{
  RectificationOptions rectification = options_.rectification;
  rectification.folder = observations;
  rectification.output = folderOf("rectification");
  rectification.write_map = false;
  rectification.skip_broken = options_.texture.skip_broken;
  rectification.stage.setOdometryNoise(noise);
  if (!posed.shift().isZero(0) && !rectification.up)
    rectification.up = Eigen::Vector3d::UnitZ(); // of a surveyed grid
  return runPoses("rectification",
                  {{"observations", observations},
                   {"skips_broken", rectification.skip_broken},
                   {"files", sequenceState(observations)},
                   {"scale", scale},
                   {"options", values_(rectification_group)}},
                  posed,
                  [&](StageLog& log) {
                    return rectifyPoses(rectification, posed, controls_, log);
                  });
}

ObservationSequence
Chain::adjust(const std::string& observations,
              const ObservationSequence& posed,
              bool rectifies,
              const OdometryNoise& noise,
              double scale)
{
  return runPoses(
      "adjustment",
      {{"observations", observations},
       {"files", sequenceState(observations)},
       {"scale", scale},
       {"odometry_noise",
        {noise.length, noise.length_per_metre, noise.turn, noise.turn_per_radian}}},
      posed,
      [&](StageLog& log) {
        StepTimer timer(log.report);
        EstimatedPoses poses;
        Trajectory before;
        if (rectifies)
          before = loadTrajectory(
              (fs::path(folderOf("rectification")) / "trajectory_before.txt").string());
        poses.trajectory = adjustPoses(posed, before.poses, noise, controls_, log);
        for (std::size_t i = 0; i < posed.size(); ++i)
          poses.places.push_back(i);
        poses.up = poses_.up;
        timer.finish("adjust");
        return poses;
      });
}

ObservationSequence
Chain::runPoses(const std::string& name,
                Json made_of,
                const ObservationSequence& sequence,
                const std::function<EstimatedPoses(StageLog&)>& work)
{
  const std::string folder = folderOf(name);
  run(name, std::move(made_of), [&](StageLog& log) {
    saveEstimatedPoses(folder, work(log));
    return std::vector<std::string>();
  });
  const std::optional<EstimatedPoses> poses = loadEstimatedPoses(folder);
  if (!poses)
    throw InputFileException(folder + ": has no poses");
  poses_ = *poses;
  return sequence.withPoses(poses->places, poses->trajectory);
}

} // namespace pcl::acmap
