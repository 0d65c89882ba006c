#pragma once

#include "told.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace pcl::acmap {

/** \brief A folder with stage.json: of which inputs and options its stage's results are.
 *
 * A run that comes later takes them instead of making them again, as long as inputs, options
 * and results are what they were. Files are compared by name, size and time. */
class StageFolder {
public:
  /** \param[in] path of the folder
   * \param[in] made_of inputs and options, as \ref stateOf and the like give them
   * \param[in] result_folder where the results lie; empty: in it */
  StageFolder(std::string path,
              nlohmann::ordered_json made_of,
              std::string result_folder = {});

  /** \brief What the stage told when it was finished; nothing when it has to be run. */
  std::optional<Told>
  finished() const;

  /** \brief Makes the folder ready for a run: empty, but for what an interrupted run of
   * the same left to go on from.
   * \throws OutputFileException when it cannot be made or emptied, or holds what is not of
   * a stage */
  void
  begin() const;

  /** \brief Notes that the results are whole, and removes those of an earlier run that
   * have no successor.
   * \param[in] names of the result files
   * \return names of what was removed
   * \throws OutputFileException */
  std::vector<std::string>
  finish(const Told& told, const std::vector<std::string>& names) const;

  /** \brief The same for all files of the folder. */
  std::vector<std::string>
  finish(const Told& told) const;

  /** \brief Removes the folder, and what it lies in where that is empty by then: nothing
   * in it is of use. It stays where it tells whose the results elsewhere are. */
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

  /** \brief States of the results of the runs before, as stage.json has them. */
  nlohmann::ordered_json
  earlierResults() const;

  /** \throws OutputFileException when the folder holds what no run put there */
  void
  requireNoStrangers(const nlohmann::ordered_json& earlier) const;

  /** \brief Empties the folder, but for what tells whose the results elsewhere are until a
   * new state does. */
  void
  removeAllButState(std::error_code& error) const;

  /** \brief Removes results of the runs before that this one has not, as far as nobody has
   * changed them.
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

/** \brief Names of the regular files of a folder that are not hidden, in order.
 * \throws InputFileException when it cannot be listed */
std::vector<std::string>
filesIn(const std::string& folder);

/** \brief Names, sizes and times of files, by which it is told whether they have changed; a
 * file that is missing has neither. */
nlohmann::ordered_json
stateOf(const std::string& folder, const std::vector<std::string>& names);

/** \brief The same of one file. */
nlohmann::ordered_json
stateOfFile(const std::string& path);

/** \brief A few letters that stand for a text of any length. */
std::string
fingerprint(const nlohmann::ordered_json& json);

} // namespace pcl::acmap
