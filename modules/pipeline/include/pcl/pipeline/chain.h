#pragma once

#include <pcl/core/cloud_rows.h>
#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/stage_controls.h>
#include <pcl/core/trajectory.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/mapping/map_levelling.h>
#include <pcl/pipeline/compact_mapping_types.h>
#include <pcl/pipeline/cost_callback.h>
#include <pcl/pipeline/detail_mesh.h>
#include <pcl/pipeline/estimated_poses.h>
#include <pcl/pipeline/observation_merging.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/plane_mapping.h>
#include <pcl/pipeline/plane_sightings.h>
#include <pcl/pipeline/pose_convention_check.h>
#include <pcl/pipeline/ranked_work.h>
#include <pcl/pipeline/ranks.h>
#include <pcl/pipeline/sequence_consolidation.h>
#include <pcl/pipeline/stage_store.h>
#include <pcl/pipeline/visual_odometry.h>
#include <pcl/texture/plane_texturing.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

class ScratchMemory;

namespace acmap {

class ObservationStream;

/** \brief The steps of a chain, each with its settings; threads and progress are those of
 * the chain. \ingroup pipeline */
struct ChainSettings {
  MappingMode mode = MappingMode::Accurate;
  PoseConventionCheck poses; ///< of recorded poses
  VisualOdometry odometry;
  MapLevelling<PointNormal> levelling;
  EntropyRectification<PointNormal> rectification;
  bool rectify = true;
  bool rectifies_one = false; ///< one observation, too: it is only levelled
  bool adjust = false;
  /** \brief Finds out what the path of the camera is: one in space is adjusted, and estimated with
   * six degrees of freedom where its poses are not known. */
  bool measure_path = false;
  bool skip_broken = false;
  ObservationMerging merging;
  PlaneMapping planes;
  PlaneTexturing<PointXYZRGB> texturing;
  std::size_t max_detail_bytes = default_detail_bytes; ///< 0: a map without details
};

/** \brief One cloud. */
struct ChainCloud {
  CloudRows rows;                             ///< metres
  std::shared_ptr<const PointCloudFile> file; ///< sensor, up direction and shift
  std::vector<Eigen::Vector3f> viewpoints;    ///< of its field `view`, metres
  /** \brief The map in its frame; a cloud of merged observations has one of its own. */
  Eigen::Isometry3d T_cloud_map = Eigen::Isometry3d::Identity();
};

/** \brief What the stages of a chain hand on. \ingroup pipeline */
struct ChainState {
  /** \brief With the poses of the last stage; none for one cloud. */
  std::optional<ObservationSequence> observations;
  /** \brief The same before that stage. */
  std::optional<ObservationSequence> given;
  bool has_poses = false;                     ///< Are those of the input known?
  std::optional<ObservationSequence> earlier; ///< of the map that is extended
  std::shared_ptr<ObservationStream> stream;  ///< that made the observations, or null
  EstimatedPoses estimated;                   ///< by the last stage with poses
  /** \brief Consolidated points of the new observations that have a pose, if they were
   * made when these were read first; else empty. */
  std::vector<ConsolidatedObservation> consolidated;
  bool is_path_in_space = false; ///< as it was measured
  OdometryNoise noise;           ///< of the poses that are rectified and adjusted
  /** \brief Input of the rectification, if it ran. */
  ConsolidatedObservations rectified;
  Trajectory before; ///< poses before the rectification, level; empty without one
  ChainCloud cloud;  ///< merged, or the input; empty once planes are found
  MappedPlanes planes;
  PlaneSightings sightings; ///< of these planes

  CompactMap map;
  std::shared_ptr<RankedWork> work; ///< of other ranks; or null

  CompactMappingReport report; ///< of the stages that ran
  /** \brief Seconds of the steps of the last stage, and remarks that no stage before it
   * has made. */
  Report stage;
};

/** \brief How a stage runs. */
struct StageRun {
  unsigned threads = 0;      ///< 0: all
  ProgressCallback progress; ///< of this stage
  CostCallback cost;         ///< may be empty
  std::shared_ptr<Ranks> ranks;
  std::string scratch_folder; ///< empty: none
  std::size_t scratch_resident = 0;
};

/** \brief A row of the list of stages. \ingroup pipeline */
struct ChainStage {
  std::string name; ///< also of its folder, and in reports
  /** \brief Are its results kept? Those of other stages are too large: such a stage runs
   * only if a later one must run. */
  bool is_kept = true;
  std::function<bool(const ChainState&, const ChainSettings&)>
      applies; ///< empty: always
  /** \brief Adds the inputs and settings that the chain does not know. */
  std::function<void(const ChainState&, const ChainSettings&, StageKey&)> key;
  std::function<void(ChainState&, const ChainSettings&, const StageRun&, OpenStage&)>
      run;
  /** \brief Takes what \ref run has put in an earlier run. */
  std::function<void(ChainState&, const ChainSettings&, const StageStore&)> take;
  std::string result_folder; ///< of its files; empty: its own folder in the store
  /** \brief Seconds that it takes on two processors of today, and more of them for each
   * million points: weights of the stages in the progress of the chain. */
  double seconds = 0, seconds_per_million = 0;
};

/** \brief A stage of the last run. */
struct DoneStage {
  std::string name;
  std::string told;                 ///< by the callback, in this run or an earlier one
  bool is_taken = false;            ///< from an earlier run
  std::vector<std::string> removed; ///< results of an earlier run that are not replaced
};

/** \brief Makes a map, at once or while observations arrive, alone or on ranks, with its
 * results in memory or in folders: `egomotion`, `extension`, `rectification`, `adjustment`,
 * `merging`, `planes`, `texture`.
 *
 * A stage is taken over from a store if its key and its files are as they were, and no stage
 * before it ran. \ref CompactMapping is this chain with inputs of a program; the tools
 * append a stage that writes the map. \ingroup pipeline */
class ACMAP_EXPORT Chain : public StageControls<CompactMappingReport> {
public:
  /** \brief Called when a stage has run, before it is finished; may write further files
   * into its folder. Its result is kept with it: a JSON object, or nothing. */
  using StageCallback = std::function<std::string(
      const std::string& stage, const ChainState& state, OpenStage& open)>;

  /** \brief Reads the input when it is needed. */
  using CloudLoader = std::function<ChainCloud()>;

  Chain();

  explicit Chain(ChainSettings settings);

  ~Chain();

  ChainSettings&
  settings()
  {
    return settings_;
  }

  const ChainSettings&
  settings() const
  {
    return settings_;
  }

  /** \brief Sets the observations.
   * \param[in] has_poses Are their poses known? */
  void
  setInput(const ObservationSequence& observations, bool has_poses);

  /** \brief The same for observations that were processed as they arrived.
   * \param[in] stream has ended */
  void
  setInput(std::shared_ptr<ObservationStream> stream,
           const ObservationSequence& observations,
           bool has_poses);

  /** \brief Sets one cloud.
   * \param[in] state that changes with it, for keys */
  void
  setInputCloud(CloudLoader load, const std::string& state);

  /** \brief Sets a stage that makes the observations, before all others, of those of \ref setInput if
   * there are some. It sets ChainState::observations and has_poses. */
  void
  setFirstStage(ChainStage stage);

  /** \brief Sets the observations of an earlier map, which is extended. */
  void
  setEarlierObservations(const ObservationSequence& sequence)
  {
    earlier_ = sequence;
  }

  /** \brief Sets where results are kept (default: in memory). */
  void
  setStore(StageStore store)
  {
    store_ = std::move(store);
  }

  const StageStore&
  getStore() const
  {
    return store_;
  }

  /** \brief Adds a stage behind all others. */
  void
  append(ChainStage stage)
  {
    stages_.push_back(std::move(stage));
  }

  void
  setStageCallback(StageCallback callback)
  {
    callback_ = std::move(callback);
  }

  /** \brief Sets what is called before planes are found and painted, with the memory and
   * time that this may take; what it throws, \ref run throws. */
  void
  setCostCallback(CostCallback callback)
  {
    cost_ = std::move(callback);
  }

  /** \brief \ref CompactMapping::setRanks, for the process that makes the map. */
  void
  setRanks(std::shared_ptr<Ranks> ranks)
  {
    ranks_ = std::move(ranks);
  }

  /** \brief \ref CompactMapping::setScratchFolder.
   * \param[in] limit bytes of memory from which on points go to files; 0: at once */
  void
  setScratchFolder(std::string folder, std::size_t resident, std::size_t limit = 0);

  /** \brief Would \ref run take a stage over, whose name and key are given, if all stages
   * before it are taken over?
   * \param[in] wanted the stage in question, as it would be appended */
  bool
  wouldTake(const ChainStage& wanted);

  /** \brief Runs the stages that cannot be taken over.
   * \param[in] last of them; empty: all
   * \throws EmptyInputException if no observation could be joined to another one, or no
   * place of an earlier map was seen again
   * \throws InputFileException if the views contradict recorded poses
   * \throws what the stages throw; OutputFileException if the store cannot be written
   * \throws CancelledException if the progress callback stopped it; finished stages stay */
  const ChainState&
  run(const std::string& last = {});

  /** \brief After \ref run, or when it threw: as far as it came. */
  const ChainState&
  state() const
  {
    return state_;
  }

  ChainState&
  state()
  {
    return state_;
  }

  /** \brief Name of the stage that runs, or ran last. */
  const std::string&
  running() const
  {
    return running_;
  }

  /** \brief The stages that were run or taken over. */
  const std::vector<DoneStage>&
  done() const
  {
    return done_;
  }

private:
  void
  begin();

  /** \brief Finds out what the path of known poses is. */
  void
  measurePath();

  /** \brief Compares recorded poses with the views. */
  void
  checkPoses();

  bool
  applies(const ChainStage& stage) const;

  /** \brief Fraction of the progress at the end of a stage of \ref run_stages_, which begins now. */
  double
  endOf(const ChainStage& stage) const;

  StageKey
  keyOf(const ChainStage& stage) const;

  void
  runStage(const ChainStage& stage, OpenStage& open);

  void
  runKept(const ChainStage& stage, const StageKey& key);

  void
  runPassing(const ChainStage& stage);

  /** \return false if the stage has to be run */
  bool
  takeOver(const ChainStage& stage, const StageKey& key);

  std::vector<ChainStage>
  allStages() const;

  ChainSettings settings_;
  std::vector<ChainStage> stages_;
  std::optional<ChainStage> first_;
  std::optional<ObservationSequence> input_, earlier_;
  std::shared_ptr<ObservationStream> stream_;
  bool has_poses_ = false;
  CloudLoader load_cloud_;
  std::string cloud_state_;
  StageStore store_;
  StageCallback callback_;
  CostCallback cost_;
  std::shared_ptr<Ranks> ranks_;
  std::string scratch_folder_;
  std::size_t scratch_resident_ = 0, scratch_limit_ = 0;
  std::shared_ptr<ScratchMemory> scratch_; ///< while a run lasts

  std::vector<ChainStage> run_stages_; ///< of the last run
  ChainState state_;
  std::vector<DoneStage> done_;
  std::string running_;
  std::string key_before_; ///< fingerprint of the key of the stage before
  double progress_before_ = 0;
};

} // namespace acmap
} // namespace pcl
