#include "map_run.h"

#include "active_stereo/stereo_options.h"
#include "drawn_apart.h"
#include "length_check.h"
#include "live_map.h"
#include "live_window.h"
#include "map_stage.h"
#include "reading_options.h"

#include <pcl/core/cloud_rows.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/fields_json.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/map_shift.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/core/process_memory.h>
#include <pcl/pipeline/map_rows.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_list.h>
#include <pcl/pipeline/observation_writing.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <utility>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* first_stage = "observations";
constexpr const char* last_stage = "map";

StageLog
logIn(const std::string& told, const std::string& stage, const StageStore& store)
{
  try {
    return stageLogIn(Json::parse(told));
  }
  catch (const nlohmann::json::exception&) {
    throw InputFileException(store.path(stage) +
                             ": is damaged; remove it, and the stage runs again");
  }
}

/** Every n-th point of a map, for display: at most a million points. */
PCLPointCloud2
thinned(const ChainCloud& merged)
{
  constexpr std::size_t maximum = 1000000;
  const PCLPointCloud2 few = everyNth(merged.rows, merged.rows.size() / maximum + 1);
  return movedRows(merged.T_cloud_map.inverse(), CloudRows::of(few)).copy();
}

/** Reports how much the processes had to tell each other. */
void
tellRanks(const CompactMappingReport& report, StageLog& log)
{
  constexpr double megabyte = 1e6;
  log.details["ranks"] = {{"processes", report.ranks},
                          {"messages", report.rank_messages},
                          {"bytes", report.rank_bytes}};
  log.tell("ranks",
           std::to_string(report.ranks) + ", " +
               shortNumber(static_cast<double>(report.rank_bytes) / megabyte) +
               " MB in " + std::to_string(report.rank_messages) + " messages");
}

/** Writes the observations of a file or an RGB-D folder as PCDs. */
void
importRecording(const std::string& path,
                const ObservationSequence& sequence,
                const std::string& folder,
                const RunControls& controls,
                StageLog& log)
{
  StepTimer timer(log.report);
  OutputFolder output(folder);
  std::size_t points = 0;
  const auto count = [&](const ObservationToWrite& written) {
    points += rowsOf(*written.cloud);
  };
  writeObservations(output, sequence, {controls.progress, "reading " + path, count});
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

void
tellMerging(const MergingReport& report, std::size_t max_points, StageLog& log)
{
  if (report.every > 1)
    log.warn("the map has more than " + std::to_string(max_points) +
             " points (--max-points): it is made of each " +
             std::to_string(report.every) + "th of them");
  log.details["observations"] = report.observations;
  log.tell("read",
           std::to_string(report.observations) + " observations, " +
               std::to_string(report.points) + " points");
  if (report.refined > 0)
    log.tell("refined",
             "the quantised depth of " + std::to_string(report.refined) +
                 " observations");
}

} // namespace

ChainSettings
settingsOf(const ChainOptions& options, unsigned threads)
{
  ChainSettings settings;
  if (options.planes.paper)
    settings.mode = MappingMode::Paper;
  settings.poses = options.poses;
  settings.odometry.setEgomotion(options.egomotion.stage);
  if (options.rectification.up)
    settings.levelling.setUpDirection(*options.rectification.up);
  settings.rectification = options.rectification.stage;
  settings.rectify = options.rectifies;
  settings.adjust = options.egomotion.isRigid();
  settings.measure_path = options.egomotion.measures_path && !options.planes.paper;
  settings.skip_broken = options.texture.skip_broken;
  settings.merging = mergingOf(options, threads);
  settings.planes = mappingOf(options.planes, threads);
  settings.texturing = options.texture.stage;
  settings.max_detail_bytes = options.max_detail_bytes;
  return settings;
}

void
tellExtension(const SequenceAlignmentReport& report, StageLog& log)
{
  log.details["proposals"] = report.revisits.proposals;
  log.details.update(fieldsOf(report, {{"revisits"}}));
  log.tell("joined",
           "at " + std::to_string(report.agreeing) + " of " +
               std::to_string(report.places) + " places that both maps have seen");
}

void
tellQuality(const CompactMappingReport& report, StageLog& log)
{
  if (report.quality) {
    log.details["quality"] = fieldsOf(*report.quality);
    log.tell("quality", describeQuality(*report.quality));
  }
  if (report.next_positions)
    log.details["next_positions"] = fieldsOf(*report.next_positions);
}

MapRun::MapRun(const ChainOptions& options,
               ValuesOfGroup values,
               const RunControls& controls,
               const PicturesApart& pictures,
               OutputFolder& folder,
               StageLog& log)
: options_(options)
, values_(std::move(values))
, controls_(controls)
, pictures_(pictures)
, folder_(folder)
, log_(log)
, chain_(settingsOf(options, controls.threads))
{
  chain_.setStore(StageStore((fs::path(options.output) / "stages").string()));
  chain_.setScratchFolder(folder.path(""), residentScratch(), memoryLimit());
  chain_.setRanks(options.ranks);
  chain_.setCostCallback(costCheck(controls_));
  chain_.setNumberOfThreads(controls.threads);
  chain_.setProgressCallback(controls.progress);
  chain_.setStageCallback([this](const std::string& stage,
                                 const ChainState& state,
                                 OpenStage& open) { return tell(stage, state, open); });
  if (!options.earlier.empty())
    chain_.setEarlierObservations(openMappedObservations(options.earlier));
}

void
MapRun::setInput(const MapInput& input)
{
  const bool is_cloud = input.start == StartingPoint::Cloud;
  const bool has_poses = input.start == StartingPoint::PosedObservations;
  if (input.observations)
    chain_.setInput(*input.observations, has_poses);
  if (is_cloud)
    chain_.setInputCloud([this] { return loadCloud(); },
                         stateOfFile(options_.input) + " " +
                             jsonText(values_(input_group)));
  else if (!input.observations || !input.observations->areFiles())
    chain_.setFirstStage(observationStage(input));
}

ChainStage
MapRun::observationStage(const MapInput& input)
{
  const bool is_session = input.start == StartingPoint::Session;
  const std::string folder = chain_.getStore().path(first_stage);
  ChainStage stage;
  stage.name = first_stage;
  stage.seconds_per_million = 0.6;
  stage.take = [this, input, folder, is_session](
                   ChainState& state, const ChainSettings&, const StageStore&) {
    const double scale = is_session ? 1 : controls_.reader.getScale();
    const Eigen::Vector3d shift =
        is_session ? Eigen::Vector3d::Zero().eval() : state.observations->shift();
    const bool is_shifted = !shift.isZero(0);
    state.observations.emplace(folder,
                               scale,
                               is_shifted ? std::optional<Eigen::Vector3d>()
                                          : controls_.reader.getShift());
    if (is_shifted)
      state.observations = state.observations->withShift(scale * shift);
    state.has_poses = input.start == StartingPoint::PosedObservations ||
                      !options_.stereo.poses.empty();
  };
  stage.key =
      [this, is_session](const ChainState& state, const ChainSettings&, StageKey& key) {
        key.add("input",
                is_session ? stateOf(options_.input, filesIn(options_.input))
                           : state.observations->fingerprint());
        key.add("options",
                jsonText(values_(is_session ? stereo_group : recording_group)) +
                    (is_session ? "" : jsonText(values_(bag_group))));
        key.add("scale", controls_.reader.getScale());
        if (const auto& shift = controls_.reader.getShift())
          key.add("shift", shiftText(*shift));
        if (!options_.stereo.poses.empty())
          key.add("poses", stateOfFile(options_.stereo.poses));
      };
  stage.run =
      [this, folder, is_session, take = stage.take](ChainState& state,
                                                    const ChainSettings& settings,
                                                    const StageRun& run,
                                                    OpenStage& open) {
        RunControls controls = controls_;
        controls.progress = run.progress;
        first_log_ = StageLog();
        if (is_session) {
          StereoOptions stereo = options_.stereo;
          stereo.session = options_.input;
          stereo.output = folder;
          stereo.goes_on = true;
          try {
            makeObservations(stereo, controls, first_log_);
          }
          catch (const InterruptedPartway&) {
            open.keepParts();
            throw;
          }
        }
        else
          importRecording(
              options_.input, *state.observations, folder, controls, first_log_);
        take(state, settings, chain_.getStore());
      };
  return stage;
}

ChainCloud
MapRun::loadCloud()
{
  ChainCloud cloud;
  const auto file = std::make_shared<PointCloudFile>();
  cloud.rows = controls_.reader.readRows(options_.input, *file);
  requirePoints(cloud.rows);
  cloud.viewpoints = viewpointsOfFile(
      *file, options_.input, controls_.reader.getScale(), map_log_.report.remarks);
  cloud.file = file;
  return cloud;
}

ChainStage
MapRun::mapStage(bool has_pictures, bool is_cloud)
{
  ChainStage stage;
  stage.name = last_stage;
  stage.result_folder = options_.output;
  stage.key = [this, has_pictures, is_cloud](
                  const ChainState&, const ChainSettings&, StageKey& key) {
    Json values = values_(map_group);
    if (is_cloud) // what is stated of it is not used before the map
      values.update(values_(input_group));
    values.erase("--no-pictures");
    key.add("options", jsonText(values));
    key.add("pictures", has_pictures ? "yes" : "no");
  };
  stage.seconds = has_pictures ? 4.5 : 1.5;
  stage.seconds_per_million = 0.1;
  stage.run = [this](ChainState& state,
                     const ChainSettings&,
                     const StageRun& run,
                     OpenStage& open) {
    stopIfInterrupted();
    if (state.observations) {
      saveTrajectory(folder_.path(trajectory_name), state.map.trajectory);
      saveObservationList((fs::path(options_.output) / observation_list_name).string(),
                          options_.output,
                          *state.observations);
    }
    if (!state.before.poses.empty())
      takeAlong(chain_.getStore(), state.before, folder_);
    try {
      open.setResults(writeMap(options_,
                               state.planes,
                               state.map,
                               pictures_,
                               run.progress,
                               folder_,
                               map_log_));
    }
    catch (const InterruptedPartway&) {
      open.keepParts();
      throw;
    }
  };
  return stage;
}

std::string
MapRun::tell(const std::string& stage, const ChainState& state, OpenStage& open)
{
  controls_.finished(stage);
  StageLog log;
  if (stage == first_stage)
    log = std::move(first_log_);
  else if (stage == last_stage)
    log = std::move(map_log_);
  else if (open.path("").empty()) {
    tellPassing(stage, state);
    return {};
  }
  else
    tellPoses(stage, state, open, log);
  return jsonText(jsonOf(log));
}

void
MapRun::tellPoses(const std::string& stage,
                  const ChainState& state,
                  const OpenStage& open,
                  StageLog& log) const
{
  const CompactMappingReport& report = state.report;
  log.report.seconds = state.stage.seconds;
  StepTimer timer(log.report);
  if (stage == "egomotion") {
    EgomotionOptions egomotion = options_.egomotion;
    egomotion.output = open.path("");
    tellOdometry(egomotion, *state.given, *report.odometry, open.path("plan.png"), log);
  }
  else
    log.warn(state.stage.remarks);
  if (stage == "extension")
    tellExtension(*report.extension, log);
  if (stage == "rectification") {
    RectificationOptions rectification = options_.rectification;
    rectification.folder = options_.input;
    rectification.output = open.path("");
    const ObservationSequence& posed = *state.observations;
    savePictures(drawRectification(state.rectified.clouds,
                                   state.before.poses,
                                   state.estimated.trajectory.poses,
                                   report.levelling->axis,
                                   report.rectification->steps),
                 [&](const char* name) { return open.path(name); });
    tellConsolidated(*report.consolidation,
                     posed.size(),
                     rectification.stage.getMode() == RectificationMode::Paper,
                     log);
    tellRectification(rectification, *report.levelling, *report.rectification, log);
    log.details["posed_files"] = posed.names();
  }
  if (stage == "adjustment")
    tellAdjustment(*report.adjustment, report.revisits, log);
  timer.finish("write");
  log.tellSeconds();
}

void
MapRun::tellPassing(const std::string& stage, const ChainState& state)
{
  const CompactMappingReport& report = state.report;
  map_log_.warn(state.stage.remarks);
  if (stage != "planes") // its steps are told one by one
    for (const auto& step : state.stage.seconds)
      map_log_.report.seconds.push_back(step);
  if (stage == "cloud" || stage == "merging") {
    if (const double size = options_.planes.stage.getConsolidation().getVoxelSize();
        size > 0)
      requireFineLength(
          "--consolidate", size, requirePoints(state.cloud.rows), map_log_);
  }
  if (stage == "merging")
    tellMerging(report.merging, options_.max_points, map_log_);
  if (stage == "planes") {
    tellMapping(report.planes, map_log_);
    warnOfSensor(options_.planes, state.planes, map_log_);
    if (state.observations)
      savePointCloud(folder_.path("map.pcd"), thinned(state.cloud));
    requirePlanes(options_.input, state.planes, map_log_);
  }
  if (stage == "texture") {
    tellTexture(report.texture, map_log_);
    tellQuality(report, map_log_);
    if (report.ranks > 1)
      tellRanks(report, map_log_);
  }
}

void
MapRun::throwInterrupted(std::string last) const
{
  std::string finished = std::move(last);
  for (auto stage = chain_.done().rbegin(); stage != chain_.done().rend(); ++stage)
    finished = stage->name + (finished.empty() ? "" : ", ") + finished;
  throw InterruptedPartway("interrupted; finished by then, and kept in " +
                           chain_.getStore().path("") +
                           " for the next run: " + finished);
}

void
MapRun::replay()
{
  std::mutex drawing;
  const auto window = options_.live
                          ? std::make_unique<LiveWindow>(drawing, "pcl_compact_mapping")
                          : nullptr;
  StageKey key; // whoever asks for a replay does not want an earlier one
  key.add("replayed",
          std::to_string(std::chrono::system_clock::now().time_since_epoch().count()));
  const StageStore& store = chain_.getStore();
  OpenStage open = store.begin(last_stage, key, options_.output);
  try {
    ReplayedMap made = mapAsRecorded(options_,
                                     store.path("replay"),
                                     pictures_,
                                     window.get(),
                                     folder_,
                                     controls_,
                                     map_log_);
    open.setResults(std::move(made.files));
    missing_ = std::move(made.missing);
  }
  catch (const InterruptedPartway&) {
    open.keepParts();
    throwInterrupted(std::string(last_stage) + " in part");
  }
  catch (...) {
    log_.warn(map_log_.report.remarks);
    throw;
  }
  const StageNotes notes = {jsonText(jsonOf(map_log_)), {}};
  stages_.push_back({last_stage, std::move(map_log_), false, open.finish(notes)});
}

void
MapRun::run(const MapInput& input)
{
  setInput(input);
  // pictures of the same map are kept, even if this run would not draw any
  const bool is_cloud = input.start == StartingPoint::Cloud;
  const bool has_pictures =
      pictures_.canBeDrawn() || chain_.wouldTake(mapStage(true, is_cloud));
  chain_.append(mapStage(has_pictures, is_cloud));
  try {
    chain_.run();
  }
  catch (const InterruptedPartway&) {
    throwInterrupted((chain_.running() == first_stage ? first_stage : last_stage) +
                     std::string(" in part"));
  }
  catch (const CancelledException&) {
    if (chain_.done().empty())
      throw;
    throwInterrupted("");
  }
  catch (const UnorganizedPointCloudException&) {
    throw UsageError(needs_picture);
  }
  catch (...) { // remarks often explain the failure
    log_.warn(first_log_.report.remarks);
    log_.warn(map_log_.report.remarks);
    log_.warn(chain_.state().stage.remarks);
    throw;
  }
  for (const DoneStage& done : chain_.done())
    stages_.push_back({done.name,
                       logIn(done.told, done.name, chain_.getStore()),
                       done.is_taken,
                       done.removed});
}

} // namespace pcl::acmap
