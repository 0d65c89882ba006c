#pragma once

#include "stage_log.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace pcl::acmap {

/** \brief A folder with a stage.json, which records the inputs, options and results of
 * a stage.
 *
 * A later run reuses the results as long as inputs, options and results are unchanged.
 * Files are compared by name, size and time. */
class StageFolder {
public:
  /** \param[in] path of the folder
   * \param[in] made_of inputs and options, as returned by \ref stateOf and similar
   * functions
   * \param[in] result_folder folder of the results; empty: this folder */
  StageFolder(std::string path,
              nlohmann::ordered_json made_of,
              std::string result_folder = {});

  /** \brief The report of the stage if it is finished; nothing if it has to be run. */
  std::optional<StageLog>
  finished() const;

  /** \brief Prepares the folder for a run: empties it, except for results from which an
   * interrupted run with the same inputs can be continued.
   * \throws OutputFileException when it cannot be created or emptied, or holds files
   * that do not belong to a stage */
  void
  begin() const;

  /** \brief Records that the results are complete, and removes results of an earlier
   * run that were not replaced.
   * \param[in] names of the result files
   * \return names of the removed files
   * \throws OutputFileException */
  std::vector<std::string>
  finish(const StageLog& told, const std::vector<std::string>& names) const;

  /** \brief The same for all files of the folder. */
  std::vector<std::string>
  finish(const StageLog& told) const;

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
  nlohmann::ordered_json
  earlierResults() const;

  /** \throws OutputFileException when the folder holds files that no run wrote */
  void
  requireNoStrangers(const nlohmann::ordered_json& earlier) const;

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
  write(const nlohmann::ordered_json& state) const;

  nlohmann::ordered_json
  results(const std::vector<std::string>& names) const;

  std::string path_;
  nlohmann::ordered_json made_of_;
  std::string result_folder_;
};

/** \brief Names of the regular files of a folder that are not hidden, sorted.
 * \throws InputFileException when it cannot be listed */
std::vector<std::string>
filesIn(const std::string& folder);

/** \brief Name of a picture, relative to the folder of the results: they have a folder
 * of their own. */
std::string
pictureName(const std::string& name);

/** \brief Names, sizes and times of files, by which changes are detected; a missing
 * file has only a name. */
nlohmann::ordered_json
stateOf(const std::string& folder, const std::vector<std::string>& names);

/** \brief The same for one file. */
nlohmann::ordered_json
stateOfFile(const std::string& path);

/** \brief A short hash of a JSON text. */
std::string
fingerprint(const nlohmann::ordered_json& json);

} // namespace pcl::acmap
