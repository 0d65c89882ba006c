#pragma once

#include "chain_options.h"
#include "stage_folder.h"

#include <pcl/pipeline/estimated_poses.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/sequence_alignment.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Input of the map; without observations it is one cloud. */
struct Sequence {
  std::optional<ObservationSequence> posed;
  bool is_rectified = false;         ///< true if the poses were rectified
  std::optional<Eigen::Vector3d> up; ///< axis of the map frame, if it was levelled
};

/** \brief A stage of this run. */
struct RunStage {
  std::string name;
  StageLog told;
  bool is_reused = false;
  /** \brief Results of an earlier run that this run does not have. */
  std::vector<std::string> removed;
};

/** \brief Reports how observations were joined to an earlier map. */
void
tellExtension(const SequenceAlignmentReport& report, StageLog& log);

/** \brief The stages of the pipeline to a compact map. Each has a folder of its own for
 * its results, so that a later run can reuse those that have not changed. */
class Chain {
public:
  /** \brief Returns the options of a group that the user set, with their values. */
  using ValuesOfGroup = std::function<nlohmann::ordered_json(const std::string& group)>;

  /** \param[in,out] log gets the warnings of a stage that fails
   * \param[in] folder that holds the folders of the stages */
  Chain(const ChainOptions& options,
        ValuesOfGroup values,
        RunControls controls,
        StageLog& log,
        std::string folder);

  /** \brief Computes the input of the map: observations and poses.
   * \param[in] recorded of \ref openRecording for the input
   * \throws InterruptedPartway naming the stages that are finished
   * \throws what the stages throw */
  Sequence
  sequenceFrom(StartingPoint start, const std::optional<ObservationSequence>& recorded);

  /** \brief Runs a stage, or reuses the results of an earlier run.
   * \param[in] made_of its inputs and options, in addition to the previous stages
   * \param[in] work computes the results, reports into the log that it gets, and returns
   * the names of the results; none: all files of the stage's folder
   * \param[in] result_folder of the results; empty: the stage's folder */
  const StageLog&
  run(const std::string& name,
      nlohmann::ordered_json made_of,
      const std::function<std::vector<std::string>(StageLog&)>& work,
      const std::string& result_folder = {});

  /** \brief Would \ref run reuse the results of an earlier run? */
  bool
  isFinished(const std::string& name,
             nlohmann::ordered_json made_of,
             const std::string& result_folder = {}) const;

  /** \brief Folder of the results of a stage. */
  std::string
  folderOf(const std::string& stage) const;

  const std::vector<RunStage>&
  stages() const
  {
    return stages_;
  }

private:
  void
  addState(nlohmann::ordered_json& made_of) const;

  void
  forgetWhatWasTold(StageLog& log) const;

  /** \param[in] last what the interrupted stage has finished; may be empty */
  [[noreturn]] void
  throwInterrupted(std::string last) const;

  std::string
  makeObservations();

  /** \brief Makes a folder of the observations of one file. */
  std::string
  importObservations(const ObservationSequence& recorded);

  ObservationSequence
  findPoses(const std::string& observations, double scale);

  /** \brief Adds the observations to those of an earlier map. */
  ObservationSequence
  extend(const ObservationSequence& posed);

  ObservationSequence
  rectify(const std::string& observations,
          const ObservationSequence& posed,
          const OdometryNoise& noise,
          double scale);

  /** \param[in] rectifies Were the poses rectified before? */
  ObservationSequence
  adjust(const std::string& observations,
         const ObservationSequence& posed,
         bool rectifies,
         const OdometryNoise& noise,
         double scale);

  /** \brief Runs a stage that estimates the poses of a sequence; they go from stage to
   * stage as files, so that a run that reuses them has the same bytes. */
  ObservationSequence
  runPoses(const std::string& name,
           nlohmann::ordered_json made_of,
           const ObservationSequence& sequence,
           const std::function<EstimatedPoses(StageLog&)>& work);

  const ChainOptions& options_;
  ValuesOfGroup values_;
  RunControls controls_;
  StageLog& log_;
  std::string folder_;
  std::string made_of_;  ///< fingerprint of all stages so far
  EstimatedPoses poses_; ///< of the last stage with poses
  std::vector<RunStage> stages_;
};

} // namespace pcl::acmap
