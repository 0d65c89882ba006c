#pragma once

#include "chain_options.h"
#include "live_map.h"

#include <pcl/core/output_folder.h>
#include <pcl/pipeline/chain.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

class PicturesApart;

/** \brief A stage of this run. */
struct RunStage {
  std::string name;
  StageLog told;
  bool is_reused = false;
  /** \brief Results of an earlier run that this run does not have. */
  std::vector<std::string> removed;
};

/** \brief The settings of all stages but the first and the last one.
 * \param[in] threads 0 = all */
ChainSettings
settingsOf(const ChainOptions& options, unsigned threads);

/** \brief Reports how observations were joined to an earlier map. */
void
tellExtension(const SequenceAlignmentReport& report, StageLog& log);

/** \brief Tells how good a map is, and reports it as "quality" and next_positions. */
void
tellQuality(const CompactMappingReport& report, StageLog& log);

/** \brief Makes a map by the \ref Chain, tells its stages, and writes it. */
class MapRun {
public:
  /** \brief Returns the options of a group that the user set, with their values. */
  using ValuesOfGroup = std::function<nlohmann::ordered_json(const std::string& group)>;

  /** \param[in] options are referred to, as all that follows
   * \param[in,out] log gets the warnings of a stage that fails
   * \param[in,out] folder of the map, is committed */
  MapRun(const ChainOptions& options,
         ValuesOfGroup values,
         const RunControls& controls,
         const PicturesApart& pictures,
         OutputFolder& folder,
         StageLog& log);

  /** \throws InterruptedPartway naming the stages that are finished
   * \throws NothingFound when there is no plane
   * \throws what the stages throw */
  void
  run(const MapInput& input);

  /** \brief Replays a session at its pace, and maps it meanwhile; nothing is taken over.
   * \throws the same */
  void
  replay();

  const std::vector<RunStage>&
  stages() const
  {
    return stages_;
  }

  /** \brief Observations with their poses, and those before the rectification. */
  const ChainState&
  state() const
  {
    return chain_.state();
  }

  /** \brief Why a replay ended early, if it did. */
  const std::optional<MissingObservations>&
  missing() const
  {
    return missing_;
  }

private:
  void
  setInput(const MapInput& input);

  /** \brief A stage that makes a folder of the observations of the input. */
  ChainStage
  observationStage(const MapInput& input);

  ChainCloud
  loadCloud();

  ChainStage
  mapStage(bool has_pictures, bool is_cloud);

  std::string
  tell(const std::string& stage, const ChainState& state, OpenStage& open);

  /** \brief Tells a stage whose results are not kept in the report of the map. */
  void
  tellPassing(const std::string& stage, const ChainState& state);

  void
  tellPoses(const std::string& stage,
            const ChainState& state,
            const OpenStage& open,
            StageLog& log) const;

  /** \param[in] last what the interrupted stage has finished; may be empty */
  [[noreturn]] void
  throwInterrupted(std::string last) const;

  const ChainOptions& options_;
  ValuesOfGroup values_;
  RunControls controls_;
  const PicturesApart& pictures_;
  OutputFolder& folder_;
  StageLog& log_;
  Chain chain_;
  StageLog first_log_; ///< of the stage that makes the observations
  StageLog map_log_;
  std::vector<RunStage> stages_;
  std::optional<MissingObservations> missing_;
};

} // namespace pcl::acmap
