#include "chain/chain_stages.h"
#include "poses/level_frame.h"

#include <pcl/core/impl/part_of_progress.h>
#include <pcl/pipeline/map_quality.h>
#include <pcl/pipeline/next_positions.h>
#include <pcl/pipeline/pose_errors.h>
#include <pcl/pipeline/ranked_work.h>
#include <pcl/pipeline/sequence_adjustment.h>
#include <pcl/pipeline/sequence_alignment.h>
#include <pcl/pipeline/surface_names.h>
#include <pcl/texture/floor_plan.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace pcl::acmap {

namespace {

constexpr const char* before_name = "trajectory_before.txt";

void
setPoses(ChainState& state, EstimatedPoses poses)
{
  state.given = state.observations;
  state.observations = state.given->withPoses(poses.places, poses.trajectory);
  state.estimated = std::move(poses);
}

bool
hasSeveral(const ChainState& state)
{
  return state.observations && state.observations->size() > 1;
}

/** Reads all observations into a stream, which works meanwhile. */
std::shared_ptr<ObservationStream>
fed(const ChainState& state, const ChainSettings& settings, const StageRun& run)
{
  ObservationStream::Steps steps = streamSteps(settings, run.threads);
  steps.keeps_clouds = false;
  steps.consolidates = settings.rectify;
  const auto stream = std::make_shared<ObservationStream>(std::move(steps));
  const Progress progress(run.progress);
  const ObservationSequence& sequence = *state.observations;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    progress.tell(static_cast<double>(i) / static_cast<double>(sequence.size()),
                  "estimating");
    stream->add(sequence.load(i).file, std::nullopt, sequence.path(i));
  }
  return stream;
}

void
takeNoise(ChainState& state, const ChainSettings& settings)
{
  if (state.estimated.noise && !settings.rectification.hasOdometryNoise())
    state.noise = *state.estimated.noise;
}

/** Consolidated points of the observations that have a pose, if a stream made them. */
void
takeConsolidated(ChainState& state, const ChainSettings& settings)
{
  if (!state.stream || !settings.rectify)
    return;
  const std::vector<ConsolidatedObservation>& all = state.stream->consolidated();
  for (const std::size_t place : state.estimated.places)
    state.consolidated.push_back(all[place]);
}

/** II-B.1 */
void
runOdometry(ChainState& state,
            const ChainSettings& settings,
            const StageRun& run,
            OpenStage& open)
{
  StepTimer timer(state.stage);
  const ObservationSequence& sequence = *state.observations;
  if (!state.stream)
    state.stream = fed(state, settings, run);
  state.stream->finish();
  state.report.odometry = state.stream->odometry().finish(sequence.size());
  const VisualOdometryResult& found = *state.report.odometry;
  if (found.posed() == 0)
    throw EmptyInputException(
        "no observation could be joined to another one; the first one " +
        found.reasonOf(0, sequence.names()));
  std::vector<double> stamps;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    stamps.push_back(sequence.stamp(i));
    if (!found.poses[i])
      state.stage.remarks.push_back("lost: " + sequence.name(i) + ": " +
                                    found.reasonOf(i, sequence.names()));
  }
  if (settings.measure_path)
    state.report.path = found.path();
  state.is_path_in_space = settings.measure_path && found.model == MotionModel::Rigid;
  setPoses(state, open.put(found.estimated(stamps)));
  takeNoise(state, settings);
  takeConsolidated(state, settings);
  timer.finish("estimate");
}

MotionModel
motionModelOf(const ChainState& state, const ChainSettings& settings)
{
  return state.is_path_in_space ? MotionModel::Rigid
                                : settings.odometry.getEgomotion().getMotionModel();
}

void
runExtension(ChainState& state,
             const ChainSettings& settings,
             const StageRun& run,
             OpenStage& open)
{
  StepTimer timer(state.stage);
  const ObservationSequence joined = state.earlier->followedBy(*state.observations);
  SequenceAlignment alignment;
  alignment.setInputTarget(*state.earlier);
  alignment.setMotionModel(motionModelOf(state, settings));
  alignment.setNumberOfThreads(run.threads);
  alignment.setProgressCallback(run.progress);
  const EstimatedPoses poses = open.put(
      extendedPoses(joined, state.earlier->size(), alignment, state.estimated.noise));
  state.report.extension = alignment.getReport();
  addRemarks(state.stage, state.report.extension->remarks);
  state.observations = joined;
  setPoses(state, poses);
  takeNoise(state, settings);
  timer.finish("align");
}

/** The vertical before the rectification: as it was given, that of a surveyed grid, the
 * paper's, or by the points. */
MapLevelling<PointNormal>
levellingOf(const ChainState& state, const ChainSettings& settings)
{
  MapLevelling<PointNormal> levelling = settings.levelling;
  if (levelling.getUpDirection())
    return levelling;
  if (!state.observations->shift().isZero(0))
    levelling.setUpDirection(Eigen::Vector3d::UnitZ());
  else if (settings.rectification.getMode() == RectificationMode::Paper)
    levelling.setUpDirection(-Eigen::Vector3d::UnitY());
  return levelling;
}

/** The up direction of the map; -y if it was neither found nor given. */
Eigen::Vector3d
upOf(const ChainState& state, const ChainSettings& settings)
{
  if (state.estimated.up)
    return *state.estimated.up;
  return levellingOf(state, settings)
      .getUpDirection()
      .value_or(-Eigen::Vector3d::UnitY());
}

/** The frame in which observations are mapped: the paper's is that of the map. */
LevelFrame
frameOf(const Eigen::Isometry3d& first,
        const Eigen::Vector3d& up,
        const ChainSettings& settings)
{
  return settings.mode == MappingMode::Paper ? LevelFrame() : LevelFrame(first, up);
}

LevelFrame
frameOf(const ChainState& state, const ChainSettings& settings)
{
  return frameOf(firstPoseOf(*state.observations), upOf(state, settings), settings);
}

/** Do all poses have the same height, and rotate about y only, as for motions on a
 * floor? */
bool
areOnAFloor(const std::vector<Eigen::Isometry3d>& poses)
{
  constexpr double level = 1 - 1e-8, height = 1e-4; // cosine, metres
  return poses.size() > 1 &&
         std::all_of(poses.begin(), poses.end(), [&](const Eigen::Isometry3d& pose) {
           const double rise = pose.translation().y() - poses[0].translation().y();
           return pose.linear()(1, 1) > level && std::abs(rise) < height;
         });
}

void
levelAll(ChainState& state, const ChainSettings& settings, unsigned threads)
{
  constexpr double strong = 10 * M_PI / 180;
  const bool is_on_a_floor = areOnAFloor(state.rectified.trajectory.poses);
  state.report.levelling =
      levelObservations(levellingOf(state, settings), state.rectified, threads);
  addRemarks(state.stage, state.report.levelling->remarks);
  if (state.report.levelling->tilt > strong && is_on_a_floor)
    state.stage.remarks.push_back(
        "the map was not level, but its poses turn about y only: where a hand held the "
        "camera, find them again with --6dof (of pcl_visual_egomotion or "
        "pcl_compact_mapping; MotionModel::Rigid)");
}

void
consolidateAll(ChainState& state, const ChainSettings& settings, const StageRun& run)
{
  const ObservationSequence& sequence = *state.observations;
  SequenceConsolidation consolidation;
  consolidation.setSkipBroken(settings.skip_broken);
  consolidation.setRawPoints(settings.rectification.getMode() ==
                             RectificationMode::Paper);
  consolidation.setNumberOfThreads(run.threads);
  consolidation.setProgressCallback(partOf(run.progress, 0, 0.4));
  if (state.stream && state.has_poses)
    state.consolidated = state.stream->consolidated();
  if (!state.consolidated.empty()) {
    std::vector<ConsolidatedObservation> done;
    for (std::size_t i = 0; i + state.consolidated.size() < sequence.size(); ++i)
      done.push_back( // of the earlier map
          consolidation.consolidate(*sequence.load(i).file, sequence.path(i)));
    std::move(
        state.consolidated.begin(), state.consolidated.end(), std::back_inserter(done));
    state.consolidated.clear();
    consolidation.setConsolidated(std::move(done));
  }
  consolidation.compute(sequence, state.rectified);
  state.report.consolidation = consolidation.getReport();
  addRemarks(state.stage, state.report.consolidation->remarks);
  if (state.report.consolidation->points == 0)
    throw EmptyInputException(sequence.folder().empty()
                                  ? "no observation has a point"
                                  : sequence.folder() + ": has no point");
}

/** The verdict on the poses that the map has. */
std::optional<VerdictOutcome>
verdictOf(const EntropyRectificationReport& report)
{
  if (!report.verdict)
    return std::nullopt;
  return report.outcome == RectificationOutcome::Rectified ? report.verdict->outcome
                                                           : report.verdict->given;
}

/** II-B.2 */
void
runRectification(ChainState& state,
                 const ChainSettings& settings,
                 const StageRun& run,
                 OpenStage& open)
{
  StepTimer timer(state.stage);
  consolidateAll(state, settings, run);
  timer.finish("read");
  ConsolidatedObservations& observations = state.rectified;
  levelAll(state, settings, run.threads);
  const Eigen::Vector3d& up = state.report.levelling->axis;
  EntropyRectification<PointNormal> rectification = settings.rectification;
  if (state.estimated.noise)
    rectification.setOdometryNoise(state.noise);
  rectification.setNumberOfThreads(run.threads);
  rectification.setProgressCallback(partOf(run.progress, 0.4, 1));
  EstimatedPoses poses = {
      observations.places, observations.trajectory, std::nullopt, std::nullopt};
  poses.trajectory.poses =
      rectifiedPoses(frameOf(observations.trajectory.poses.front(), up, settings),
                     observations,
                     up,
                     rectification);
  state.report.rectification = rectification.getReport();
  state.report.rectification->up = up;
  addRemarks(state.stage, state.report.rectification->remarks);
  if (state.report.levelling->found)
    poses.up = up;
  poses.verdict = verdictOf(*state.report.rectification);
  state.before = open.put(before_name, observations.trajectory);
  setPoses(state, open.put(poses));
  timer.finish("rectify");
}

void
runAdjustment(ChainState& state,
              const ChainSettings& settings,
              const StageRun& run,
              OpenStage& open)
{
  StepTimer timer(state.stage);
  const ObservationSequence& sequence = *state.observations;
  const LevelFrame frame = frameOf(state, settings);
  SequenceAdjustment adjustment;
  adjustment.setOdometryNoise(state.noise);
  adjustment.setNumberOfThreads(run.threads);
  adjustment.setProgressCallback(run.progress);
  adjustment.setPosesBefore(frame.place(state.before.poses));
  EstimatedPoses poses;
  std::vector<Eigen::Isometry3d> given;
  Trajectory placed;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    poses.places.push_back(i);
    given.push_back(sequence.pose(i));
    placed.stamps.push_back(sequence.stamp(i));
    placed.poses.push_back(frame.place(given[i]));
  }
  adjustment.compute(sequence.withPoses(poses.places, std::move(placed)),
                     poses.trajectory);
  for (std::size_t i = 0; i < given.size(); ++i)
    poses.trajectory.poses[i] = frame.inMap(poses.trajectory.poses[i], given[i]);
  state.report.adjustment = adjustment.getReport();
  state.report.revisits = adjustment.getRevisitReport();
  addRemarks(state.stage, state.report.adjustment->remarks);
  poses.up = state.estimated.up;
  poses.verdict = state.estimated.verdict;
  setPoses(state, open.put(poses));
  timer.finish("adjust");
}

void
runMerging(ChainState& state,
           const ChainSettings& settings,
           const StageRun& run,
           OpenStage&)
{
  StepTimer timer(state.stage);
  ObservationMerging merging = settings.merging;
  merging.setSkipBroken(settings.skip_broken);
  if (settings.mode != MappingMode::Paper &&
      settings.planes.getUsedDepthSensor() == DepthSensor::Laser)
    merging.setDepthSensor(DepthSensor::Laser);
  merging.setNumberOfThreads(run.threads);
  merging.setProgressCallback(run.progress);
  state.work = shareOut(run.ranks,
                        *state.observations,
                        run.threads,
                        run.scratch_folder,
                        run.scratch_resident,
                        state.stage.remarks);
  merging.setRankedWork(state.work);
  const LevelFrame frame = frameOf(state, settings);
  merging.setFrame(frame.T_frame_map());
  MergedCloud merged;
  merging.compute(*state.observations, merged);
  state.report.merging = merging.getReport();
  addRemarks(state.stage, state.report.merging.remarks);
  state.cloud = {std::move(merged.cloud),
                 nullptr,
                 std::move(merged.viewpoints),
                 frame.T_frame_map()};
  timer.finish("read");
}

/** What is known of the poses, in the frame of the cloud. */
PoseErrorModel
errorModelOf(const ChainState& state, const ChainSettings& settings)
{
  const LevelFrame frame(state.cloud.T_cloud_map);
  PoseErrorModel model;
  for (std::size_t i = 0; i < state.observations->size(); ++i)
    model.poses.push_back(frame.place(state.observations->pose(i)));
  if (state.before.poses.size() == model.poses.size())
    model.before = frame.place(state.before.poses);
  model.noise = state.noise;
  if (!settings.adjust && !state.is_path_in_space)
    model.up = frame.up(upOf(state, settings));
  return model;
}

/** Sensors of the observations, or the one of a cloud if its points prove it. */
std::vector<Eigen::Vector3f>
knownSensors(const ChainState& state)
{
  const auto& assessment = state.report.planes.assessment;
  if (!state.cloud.viewpoints.empty() || !assessment || !assessment->sensors.isKnown())
    return state.cloud.viewpoints;
  return {state.planes.sensor_origin};
}

/** II-C.1 and II-C.2 */
void
runPlanes(ChainState& state,
          const ChainSettings& settings,
          const StageRun& run,
          OpenStage&)
{
  StepTimer timer(state.stage);
  PlaneMapping planes = settings.planes;
  planes.setInputCloud(state.cloud.rows, state.cloud.file);
  planes.setViewpoints(state.cloud.viewpoints);
  if (const auto& up = settings.levelling.getUpDirection(); up && !state.observations)
    planes.setUpDirection(*up);
  if (state.observations)
    planes.setDepthSensor(
        sensorOfMerged(planes.getDepthSensor(), state.cloud.viewpoints.size()));
  planes.setNumberOfThreads(run.threads);
  if (run.cost)
    planes.setCostCallback(run.cost);
  planes.setProgressCallback(run.progress);
  planes.setRanks(run.ranks);
  planes.compute(state.planes);
  if (state.observations && settings.mode != MappingMode::Paper)
    addPoseErrors(state.cloud.rows,
                  state.planes.labels,
                  errorModelOf(state, settings),
                  state.planes.planes);
  state.report.planes = planes.getReport();
  addRemarks(state.stage, state.report.planes.remarks);
  state.sightings = collectSightings(
      state.cloud.rows, state.planes.labels, state.planes.planes, knownSensors(state));
  if (state.observations) {
    const Eigen::Isometry3d T_map_cloud = state.cloud.T_cloud_map.inverse();
    moveTo(T_map_cloud, state.planes);
    moveTo(T_map_cloud, state.sightings);
  }
  timer.finish("planes");
}

/** Sets an automatic texel size to that of the first observation: all ranks paint pictures of
 * the same size. */
void
agreeOnTexelSize(const ObservationSequence& observations,
                 bool skip_broken,
                 PlaneTexturing<PointXYZRGB>& texturing)
{
  if (texturing.getTexelSize() > 0 || texturing.getPaperMode())
    return;
  std::optional<TexturedObservation> first;
  for (std::size_t i = 0; i < observations.size() && !first; ++i)
    first = loadTextured(observations, i, skip_broken);
  if (first)
    texturing.setTexelSize(automaticTexelSize(
        texturing.getPlanes(), texturing.getCylinders(), viewOfObservation(*first)));
}

/** Adds the observations of this rank to a texturing; the other ranks paint with theirs. */
void
addObservations(const ChainState& state,
                bool skip_broken,
                PlaneTexturing<PointXYZRGB>& texturing)
{
  const ObservationSequence& sequence = *state.observations;
  RankedWork* const work = state.work.get();
  if (work)
    agreeOnTexelSize(sequence, skip_broken, texturing);
  const bool is_shared = work && work->startPainting(texturing);
  for (std::size_t i = 0; i < (is_shared ? work->own() : sequence.size()); ++i)
    texturing.addObservationLoader(
        [&sequence, i, skip_broken] { return loadTextured(sequence, i, skip_broken); });
  if (is_shared)
    texturing.addPaintedObservations([work] { return work->nextPart(); });
}

/** Tells how good the map is, and from where to look next. */
void
judgeMap(const FloorPlan& plan, const StageRun& run, ChainState& state)
{
  const UnseenSurfaces unseen = findUnseenSurfaces(state.map, plan);
  state.report.quality =
      assessMapQuality(state.map, state.sightings, unseen, state.estimated.verdict);
  NextPositions next;
  next.setNumberOfThreads(run.threads);
  next.compute(state.map, plan, unseen);
  state.report.next_positions = next.getReport();
}

/** II-C */
void
runTexturing(ChainState& state,
             const ChainSettings& settings,
             const StageRun& run,
             OpenStage&)
{
  StepTimer timer(state.stage);
  if (state.observations)
    state.cloud = ChainCloud(); // the map may need the memory
  state.map = CompactMap();
  const MappedPlanes& found = state.planes;
  if (found.planes.empty() && found.cylinders.empty())
    return;
  PlaneTexturing<PointXYZRGB> texturing = settings.texturing;
  texturing.setPlanes(found.planes);
  texturing.setCylinders(found.cylinders);
  texturing.clearObservations();
  CompactMap& map = state.map;
  if (state.observations)
    addObservations(state, settings.skip_broken, texturing);
  else
    texturing.addObservationLoader([&]() -> std::optional<TexturedObservation> {
      return TexturedObservation{
          state.cloud.rows, Eigen::Isometry3d::Identity(), 0, false};
    });
  texturing.setNumberOfThreads(run.threads);
  texturing.setProgressCallback(run.progress);
  if (run.cost)
    run.cost("painting the planes", wholeBytes(texturing.estimateMemory()), 0);
  texturing.texture(map);
  state.report.texture = texturing.getReport();
  addRemarks(state.stage, state.report.texture.remarks);
  map.details = makeDetails(found, settings.max_detail_bytes);
  map.boxes = found.boxes;
  map.recesses = found.recesses;
  if (state.observations) {
    map.up = state.estimated.up.value_or(Eigen::Vector3d::Zero());
    map.shift = state.observations->shift();
  }
  else {
    if (found.up)
      map.up = found.up->cast<double>().normalized();
    map.assumed_up = found.assumed_up.cast<double>();
    map.shift = state.cloud.file->shift;
  }

  judgeMap(nameParts(map), run, state);
  if (run.ranks && run.ranks->getNumberOfMessages() > 0) {
    state.report.ranks = run.ranks->size();
    state.report.rank_messages = run.ranks->getNumberOfMessages();
    state.report.rank_bytes = run.ranks->getNumberOfBytes();
  }
  timer.finish("paint");
}

} // namespace

std::vector<ChainStage>
chainStages()
{
  ChainStage odometry;
  odometry.name = "egomotion";
  odometry.applies = [](const ChainState& state, const ChainSettings&) {
    return !state.has_poses && hasSeveral(state);
  };
  odometry.key = [](const ChainState&, const ChainSettings& settings, StageKey& key) {
    key.addSettings("egomotion", settings.odometry.getEgomotion().settings());
    if (settings.measure_path)
      key.add("path", "measured");
  };
  odometry.run = runOdometry;
  odometry.take =
      [](ChainState& state, const ChainSettings& settings, const StageStore& store) {
        setPoses(state, store.poses("egomotion"));
        state.is_path_in_space =
            settings.measure_path && !areOnAFloor(state.estimated.trajectory.poses);
        takeNoise(state, settings);
        takeConsolidated(state, settings);
      };
  odometry.seconds_per_million = 0.6;

  ChainStage extension;
  extension.name = "extension";
  extension.applies = [](const ChainState& state, const ChainSettings&) {
    return state.earlier.has_value();
  };
  extension.key =
      [](const ChainState& state, const ChainSettings& settings, StageKey& key) {
        key.add("earlier", state.earlier->fingerprint());
        key.add("model", nameIn(motion_model_names, motionModelOf(state, settings)));
      };
  extension.run = runExtension;
  extension.take =
      [](ChainState& state, const ChainSettings& settings, const StageStore& store) {
        state.observations = state.earlier->followedBy(*state.observations);
        setPoses(state, store.poses("extension"));
        takeNoise(state, settings);
      };
  extension.seconds = 0.5;
  extension.seconds_per_million = 0.5;

  ChainStage rectification;
  rectification.name = "rectification";
  rectification.applies = [](const ChainState& state, const ChainSettings& settings) {
    return settings.rectify && (hasSeveral(state) || settings.rectifies_one);
  };
  rectification.key =
      [](const ChainState& state, const ChainSettings& settings, StageKey& key) {
        key.addSettings("rectification", settings.rectification.settings());
        key.addSettings("noise", state.noise);
        key.add("skips_broken", settings.skip_broken ? "yes" : "no");
        if (const auto& up = settings.levelling.getUpDirection())
          for (const int axis : {0, 1, 2})
            key.add("up", (*up)[axis]);
      };
  rectification.run = runRectification;
  rectification.take =
      [](ChainState& state, const ChainSettings&, const StageStore& store) {
        setPoses(state, store.poses("rectification"));
        state.before = loadTrajectory(store.path("rectification", before_name));
      };
  rectification.seconds = 0.5;
  rectification.seconds_per_million = 0.4;

  ChainStage adjustment;
  adjustment.name = "adjustment";
  adjustment.applies = [](const ChainState& state, const ChainSettings& settings) {
    return (settings.adjust || state.is_path_in_space) && hasSeveral(state);
  };
  adjustment.key = [](const ChainState& state, const ChainSettings&, StageKey& key) {
    key.addSettings("noise", state.noise);
  };
  adjustment.run = runAdjustment;
  adjustment.take =
      [](ChainState& state, const ChainSettings&, const StageStore& store) {
        setPoses(state, store.poses("adjustment"));
      };
  adjustment.seconds = 0.5;
  adjustment.seconds_per_million = 1.3;

  ChainStage merging;
  merging.name = "merging";
  merging.is_kept = false;
  merging.applies = [](const ChainState& state, const ChainSettings&) {
    return state.observations.has_value();
  };
  merging.run = runMerging;
  merging.seconds_per_million = 0.08;

  ChainStage planes;
  planes.name = "planes";
  planes.is_kept = false;
  planes.run = runPlanes;
  planes.seconds = 4;
  planes.seconds_per_million = 1.6;

  ChainStage texture;
  texture.name = "texture";
  texture.is_kept = false;
  texture.run = runTexturing;
  texture.seconds = 1.5;
  texture.seconds_per_million = 0.8;

  return {odometry, extension, rectification, adjustment, merging, planes, texture};
}

ChainStage
cloudStage(Chain::CloudLoader load)
{
  ChainStage stage;
  stage.name = "cloud";
  stage.is_kept = false;
  stage.run = [load = std::move(load)](ChainState& state,
                                       const ChainSettings&,
                                       const StageRun& run,
                                       OpenStage&) {
    StepTimer timer(state.stage);
    const Progress progress(run.progress);
    progress.tell(0, "reading");
    state.cloud = load();
    timer.finish("read");
  };
  stage.seconds = 0.1;
  stage.seconds_per_million = 0.1;
  return stage;
}

ObservationStream::Steps
streamSteps(const ChainSettings& settings, unsigned threads)
{
  ObservationStream::Steps steps;
  steps.odometry = settings.odometry;
  steps.odometry.setMeasureMotion(settings.measure_path);
  steps.odometry.setNumberOfThreads(threads);
  steps.consolidation.setRawPoints(settings.rectification.getMode() ==
                                   RectificationMode::Paper);
  steps.consolidation.setNumberOfThreads(threads);
  return steps;
}

std::optional<TexturedObservation>
loadTextured(const ObservationSequence& sequence, std::size_t i, bool skip_broken)
{
  try {
    const PosedObservation seen = sequence.load(i);
    return TexturedObservation{
        sharedCloud(seen.file), seen.T_map_camera, sequence.stamp(i), true};
  }
  catch (const InputFileException&) {
    if (!skip_broken)
      throw;
    return std::nullopt;
  }
}

} // namespace pcl::acmap
