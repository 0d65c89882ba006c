#pragma once

#include "chain_options.h"
#include "stage_folder.h"

#include <pcl/pipeline/observation_sequence.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief What a map is made of; without observations it is one cloud. */
struct Sequence {
  std::optional<ObservationSequence> posed;
  bool is_rectified = false; ///< whether the poses went through that stage
};

/** \brief A stage of this run. */
struct RunStage {
  std::string name;
  Told told;
  bool is_reused = false;
  std::vector<std::string> removed; ///< results of an earlier run that this one has not
};

/** \brief The stages on the way to a compact map, each kept in a folder of its own so that
 * a later run takes what has not changed. */
class Chain {
public:
  /** \param[in] folder where the stages' folders are */
  Chain(Tool& tool, const ChainOptions& options, std::string folder);

  /** \brief Makes what the map is made of: observations and poses.
   * \throws InterruptedPartway telling which stages are finished
   * \throws what the stages throw */
  Sequence
  sequenceFrom(StartingPoint start);

  /** \brief Runs a stage, or takes what an earlier run left.
   * \param[in] made_of its inputs and options, beside the stages before it
   * \param[in] work makes the results, and returns their names; none: all files of the
   * stage's folder
   * \param[in] result_folder where they lie; empty: the stage's folder */
  const Told&
  run(const std::string& name,
      nlohmann::ordered_json made_of,
      const std::function<std::vector<std::string>()>& work,
      const std::string& result_folder = {});

  /** \brief Whether \ref run would take what an earlier run left. */
  bool
  isFinished(const std::string& name,
             nlohmann::ordered_json made_of,
             const std::string& result_folder = {}) const;

  /** \brief Where a stage keeps its results. */
  std::string
  folderOf(const std::string& stage) const;

  const std::vector<RunStage>&
  stages() const
  {
    return stages_;
  }

private:
  /** \param[in] last what the stage that was interrupted leaves; may be empty */
  [[noreturn]] void
  throwInterrupted(std::string last) const;

  std::string
  makeObservations();

  ObservationSequence
  findPoses(const std::string& observations, double scale);

  ObservationSequence
  rectify(const std::string& observations,
          const ObservationSequence& posed,
          double scale);

  Tool& tool_;
  const ChainOptions& options_;
  std::string folder_;
  std::string made_of_; ///< fingerprint of all stages so far
  std::vector<RunStage> stages_;
};

} // namespace pcl::acmap
