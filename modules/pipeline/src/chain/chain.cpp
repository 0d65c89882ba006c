#include "chain/chain_stages.h"
#include "poses/level_frame.h"

#include <pcl/core/impl/part_of_progress.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/pipeline/chain.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

/** The part of the progress of the chain that a first stage has if nothing is known of the
 * observations that it makes. */
constexpr double share_of_first = 0.3;

/** Millions of points of what is mapped, about, by the sizes of the files. */
double
millionsIn(const ChainState& state)
{
  constexpr double million = 1e6, of_a_view = 0.3, bytes_of_a_point = 16;
  if (state.cloud.rows)
    return static_cast<double>(state.cloud.rows.size()) / million;
  double sum = 0;
  for (std::size_t i = 0; state.observations && i < state.observations->size(); ++i) {
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(state.observations->path(i), error);
    sum += error ? of_a_view : static_cast<double>(bytes) / bytes_of_a_point / million;
  }
  return sum;
}

void
appendNew(const std::vector<std::string>& remarks, std::vector<std::string>& all)
{
  for (const std::string& remark : remarks)
    if (std::find(all.begin(), all.end(), remark) == all.end())
      all.push_back(remark);
}

double
sumOf(const Report& report)
{
  double sum = 0;
  for (const auto& [step, seconds] : report.seconds)
    sum += seconds;
  return sum;
}

} // namespace

Chain::Chain()
: Chain(ChainSettings())
{}

Chain::Chain(ChainSettings settings)
: settings_(std::move(settings))
, stages_(chainStages())
{}

Chain::~Chain() = default;

void
Chain::setInput(const ObservationSequence& observations, bool has_poses)
{
  setInput(nullptr, observations, has_poses);
}

void
Chain::setInput(std::shared_ptr<ObservationStream> stream,
                const ObservationSequence& observations,
                bool has_poses)
{
  input_ = observations;
  stream_ = std::move(stream);
  has_poses_ = has_poses;
}

void
Chain::setInputCloud(CloudLoader load, const std::string& state)
{
  load_cloud_ = std::move(load);
  cloud_state_ = state;
}

void
Chain::setFirstStage(ChainStage stage)
{
  first_ = std::move(stage);
}

void
Chain::setScratchFolder(std::string folder, std::size_t resident, std::size_t limit)
{
  scratch_folder_ = std::move(folder);
  scratch_resident_ = resident;
  scratch_limit_ = limit;
}

void
Chain::begin()
{
  done_.clear();
  scratch_.reset();
  progress_before_ = 0;
  state_ = ChainState();
  if (input_)
    state_.observations = has_poses_ ? settings_.poses.read(*input_) : *input_;
  state_.has_poses = has_poses_;
  state_.stream = stream_;
  state_.earlier = earlier_;
  state_.noise = settings_.rectification.getOdometryNoise();
  state_.report.mode = settings_.mode;
  measurePath();
  key_before_ = cloud_state_;
  if (input_ && !first_ && store_.isFolder())
    key_before_ = state_.observations->fingerprint();
}

void
Chain::measurePath()
{
  if (!settings_.measure_path || !input_ || !has_poses_)
    return;
  const ObservationSequence& sequence = *state_.observations;
  std::vector<Eigen::Isometry3d> poses;
  for (std::size_t i = 0; i < sequence.size(); ++i)
    if (const auto pose = readablePose(sequence, i))
      poses.push_back(*pose);
  state_.report.path = judgePath(freeMotionOf(poses));
  state_.is_path_in_space = state_.report.path->is_in_space;
}

void
Chain::checkPoses()
{
  if (!input_ || !has_poses_ || !input_->hasRecordedPoses())
    return;
  PoseConventionCheck check = settings_.poses;
  check.setNumberOfThreads(threads_);
  check.setProgressCallback(partOf(progress_, 0, 0));
  check.compute(*input_);
  state_.report.pose_convention = check.getReport();
}

bool
Chain::applies(const ChainStage& stage) const
{
  return !stage.applies || stage.applies(state_, settings_);
}

double
Chain::endOf(const ChainStage& stage) const
{
  if (&stage == &run_stages_.back() || !progress_)
    return 1;
  double share = share_of_first;
  if (!first_ || stage.name != first_->name || state_.observations) {
    const double millions = millionsIn(state_);
    const auto secondsOf = [&](const ChainStage& one) {
      return one.seconds + millions * one.seconds_per_million;
    };
    double all = secondsOf(stage);
    const auto place = &stage - run_stages_.data();
    for (auto later = run_stages_.begin() + place + 1; later != run_stages_.end();
         ++later)
      all += applies(*later) ? secondsOf(*later) : 0;
    share = all > 0 ? secondsOf(stage) / all : 1;
  }
  return progress_before_ + (1 - progress_before_) * share;
}

StageKey
Chain::keyOf(const ChainStage& stage) const
{
  StageKey key;
  if (!store_.isFolder())
    return key;
  if (stage.key)
    stage.key(state_, settings_, key);
  if (settings_.mode == MappingMode::Paper)
    key.add("mode", "paper");
  key.add("before", key_before_);
  return key;
}

void
Chain::runStage(const ChainStage& stage, OpenStage& open)
{
  state_.stage = Report();
  running_ = stage.name;
  const double end = endOf(stage);
  const StageRun run = {threads_,
                        partOf(progress_, progress_before_, end),
                        cost_,
                        ranks_,
                        scratch_folder_,
                        scratch_resident_};
  stage.run(state_, settings_, run, open);
  progress_before_ = end;
  std::vector<std::string>& told = state_.report.remarks;
  const auto before = static_cast<std::ptrdiff_t>(told.size());
  appendNew(state_.stage.remarks, told); // a broken observation is told once
  state_.stage.remarks.assign(told.begin() + before, told.end());
  state_.report.seconds.emplace_back(stage.name, sumOf(state_.stage));
}

void
Chain::runKept(const ChainStage& stage, const StageKey& key)
{
  OpenStage open = store_.begin(stage.name, key, stage.result_folder);
  runStage(stage, open);
  StageNotes notes;
  if (callback_)
    notes.told = callback_(stage.name, state_, open);
  notes.remarks = state_.stage.remarks;
  DoneStage done{stage.name, notes.told, false, open.finish(notes)};
  done_.push_back(std::move(done));
}

void
Chain::runPassing(const ChainStage& stage)
{
  if (!scratch_ && !scratch_folder_.empty())
    scratch_ = std::make_shared<ScratchMemory>(
        scratch_folder_, scratch_resident_, scratch_limit_);
  OpenStage in_memory;
  runStage(stage, in_memory);
  if (callback_)
    callback_(stage.name, state_, in_memory);
}

bool
Chain::takeOver(const ChainStage& stage, const StageKey& key)
{
  std::optional<StageNotes> notes = store_.find(stage.name, key, stage.result_folder);
  if (!notes)
    return false;
  if (stage.take)
    stage.take(state_, settings_, store_);
  appendNew(notes->remarks, state_.report.remarks);
  done_.push_back({stage.name, std::move(notes->told), true, {}});
  return true;
}

std::vector<ChainStage>
Chain::allStages() const
{
  std::vector<ChainStage> stages;
  if (first_)
    stages.push_back(*first_);
  if (load_cloud_)
    stages.push_back(cloudStage(load_cloud_));
  stages.insert(stages.end(), stages_.begin(), stages_.end());
  return stages;
}

bool
Chain::wouldTake(const ChainStage& wanted)
{
  if (!store_.isFolder())
    return false;
  begin();
  std::vector<ChainStage> stages = allStages();
  stages.push_back(wanted);
  for (const ChainStage& stage : stages) {
    if (!stage.is_kept || !applies(stage))
      continue;
    const StageKey key = keyOf(stage);
    if (!takeOver(stage, key))
      return false;
    key_before_ = key.fingerprint();
  }
  return true;
}

const ChainState&
Chain::run(const std::string& last)
{
  begin();
  checkPoses();
  run_stages_ = allStages();
  if (const auto end =
          std::find_if(run_stages_.begin(),
                       run_stages_.end(),
                       [&](const ChainStage& stage) { return stage.name == last; });
      end != run_stages_.end())
    run_stages_.erase(end + 1, run_stages_.end());
  std::vector<const ChainStage*> passing; // until a stage behind them must run
  bool has_run = false;
  const auto run_passing = [&] {
    for (const ChainStage* const stage : passing)
      runPassing(*stage);
    passing.clear();
  };
  for (const ChainStage& stage : run_stages_) {
    if (!applies(stage))
      continue;
    if (!stage.is_kept) {
      passing.push_back(&stage);
      continue;
    }
    const StageKey key = keyOf(stage);
    if (!has_run && takeOver(stage, key)) {
      passing.clear();
      progress_before_ = endOf(stage);
    }
    else {
      run_passing();
      runKept(stage, key);
      has_run = true;
    }
    key_before_ = key.fingerprint();
  }
  run_passing();
  if (scratch_ && scratch_->getRefused() > 0)
    state_.report.remarks.push_back("the disk is full, " +
                                    std::to_string(scratch_->getRefused()) +
                                    " bytes of points stayed in memory");
  scratch_.reset();
  report_ = state_.report;
  return state_;
}

} // namespace pcl::acmap
