#pragma once

#include <pcl/pipeline/stage_store.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace pcl::acmap {

/** \brief A folder with a stage.json, which records key, notes and results of a stage.
 * Files are compared by name, size and time. */
class StageFolder {
public:
  using Json = nlohmann::ordered_json;

  /** \param[in] path of the folder
   * \param[in] result_folder folder of the results; empty: this folder */
  StageFolder(std::string path, const StageKey& key, std::string result_folder = {});

  /** \brief The notes of the stage if it is finished; nothing if it has to be run. */
  std::optional<StageNotes>
  finished() const;

  /** \brief \ref StageStore::begin. */
  void
  begin() const;

  /** \brief \ref OpenStage::finish.
   * \param[in] names of the results; none: all files of the folder */
  std::vector<std::string>
  finish(const StageNotes& notes,
         const std::optional<std::vector<std::string>>& names) const;

  /** \brief Removes the folder, and its parent if that is then empty. The folder is
   * kept if it records results of earlier runs in another folder. */
  void
  abandon() const;

  const std::string&
  path() const
  {
    return path_;
  }

private:
  bool
  isInterrupted() const;

  /** \brief States of the results of earlier runs, as in stage.json. */
  Json
  earlierResults() const;

  /** \throws OutputFileException when the folder holds files that no run wrote */
  void
  requireNoStrangers(const Json& earlier) const;

  /** \brief Empties the folder except for stage.json, which records the owner of
   * results elsewhere until it is replaced. */
  void
  removeAllButState(std::error_code& error) const;

  /** \brief Removes results of earlier runs that this run does not have, unless they
   * were changed since.
   * \return their names */
  std::vector<std::string>
  removeStale(const std::vector<std::string>& names) const;

  void
  write(const Json& state) const;

  std::string path_;
  Json made_of_;
  std::string result_folder_;
};

} // namespace pcl::acmap
