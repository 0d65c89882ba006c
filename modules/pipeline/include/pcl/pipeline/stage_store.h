#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/estimated_poses.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

class StageFolder;

/** \brief Inputs and settings that the results of a stage depend on, by name. Results of an
 * earlier run with the same key are the same. \ingroup pipeline */
class ACMAP_EXPORT StageKey {
public:
  void
  add(const std::string& name, const std::string& value)
  {
    entries_.emplace_back(name, value);
  }

  /** \brief The same for a number, all digits of which count. */
  void
  add(const std::string& name, double value);

  /** \brief Adds the fields of settings.
   * \param[in] settings struct with a `visitFields` (\ref Field) */
  template <typename Settings>
  void
  addSettings(const std::string& name, const Settings& settings)
  {
    visitFields(settings, [&](const Field& field, const auto& value) {
      addValue(name + "." + field.name, value);
    });
  }

  const std::vector<std::pair<std::string, std::string>>&
  entries() const
  {
    return entries_;
  }

  /** \brief 16 hexadecimal digits. */
  std::string
  fingerprint() const;

private:
  template <typename Value>
  void
  addValue(const std::string& name, const Value& value)
  {
    if constexpr (has_fields<Value>)
      addSettings(name, value);
    else
      add(name, static_cast<double>(value));
  }

  template <typename Value>
  void
  addValue(const std::string& name, const std::optional<Value>& value)
  {
    if (value)
      addValue(name, *value);
  }

  template <typename Enum, std::size_t size>
  void
  addValue(const std::string& name, const Named<Enum, size>& value)
  {
    add(name, std::string(nameIn(value.names, value.value)));
  }

  std::vector<std::pair<std::string, std::string>> entries_;
};

/** \brief What is kept of a stage beside its results. */
struct StageNotes {
  std::string told; ///< JSON object that the caller gave; empty: none
  std::vector<std::string> remarks;
};

/** \brief A stage in the making. Without \ref finish or \ref keepParts, it leaves nothing
 * behind. \ingroup pipeline */
class ACMAP_EXPORT OpenStage {
public:
  /** \brief A stage in memory. */
  OpenStage();

  explicit OpenStage(std::unique_ptr<StageFolder> folder);

  OpenStage(OpenStage&&) noexcept;
  OpenStage&
  operator=(OpenStage&&) noexcept;

  ~OpenStage();

  /** \brief Path of a file of the stage; empty in memory. */
  std::string
  path(const std::string& name) const;

  /** \brief Keeps poses.
   * \return as a later run reads them from the files, bit by bit, in memory, too
   * \throws OutputFileException */
  EstimatedPoses
  put(const EstimatedPoses& poses);

  /** \brief The same for a trajectory.
   * \param[in] name of the file */
  Trajectory
  put(const std::string& name, const Trajectory& trajectory);

  /** \brief What is finished of an interrupted stage survives, for a run with the same
   * key. */
  void
  keepParts()
  {
    has_ended_ = true;
  }

  /** \brief Names the files of the stage if they are in another folder (default: all files
   * of the stage's own folder). */
  void
  setResults(std::vector<std::string> names)
  {
    results_ = std::move(names);
  }

  /** \brief Records that the results are complete, and removes results of an earlier run
   * that were not replaced.
   * \return names of the removed files
   * \throws OutputFileException
   * \throws BadArgumentException if what was told is no JSON object */
  std::vector<std::string>
  finish(const StageNotes& notes);

private:
  std::unique_ptr<StageFolder> folder_; ///< null: in memory
  std::optional<std::vector<std::string>> results_;
  bool has_ended_ = false;
};

/** \brief Results of the stages of a chain: in memory, for one run, or in a folder, from
 * which a later run takes what has not changed. Each stage has a folder with a stage.json,
 * which tells its key, its results by name, size and time, and what was told of it.
 * \ingroup pipeline */
class ACMAP_EXPORT StageStore {
public:
  /** \brief In memory. */
  StageStore() = default;

  /** \param[in] folder of the stages; is created when it is needed */
  explicit StageStore(std::string folder)
  : folder_(std::move(folder))
  {}

  bool
  isFolder() const
  {
    return !folder_.empty();
  }

  /** \brief Path of a file of a stage, or of its folder; empty in memory. */
  std::string
  path(const std::string& stage, const std::string& name = {}) const;

  /** \brief Notes of a finished stage; nothing if it has to be run.
   * \param[in] result_folder of its results; empty: its own
   * \throws OutputFileException when a newer version of acmap wrote it */
  std::optional<StageNotes>
  find(const std::string& stage,
       const StageKey& key,
       const std::string& result_folder = {}) const;

  /** \brief Begins a stage: its folder is emptied, except for parts of an interrupted run
   * with the same key.
   * \throws OutputFileException when it cannot be created or emptied, or holds files that
   * do not belong to a stage */
  OpenStage
  begin(const std::string& stage,
        const StageKey& key,
        const std::string& result_folder = {}) const;

  /** \brief The poses that a stage has put.
   * \throws InputFileException when they are malformed or missing */
  EstimatedPoses
  poses(const std::string& stage) const;

private:
  std::string folder_; ///< empty: in memory
};

/** \brief A pose as it is read from a trajectory file, bit by bit, so that a map has the
 * same bytes whether stages pass poses in memory or in files. */
ACMAP_EXPORT Eigen::Isometry3d
asInFiles(Eigen::Isometry3d pose);

/** \brief Names of the regular files of a folder that are not hidden, sorted.
 * \throws InputFileException when it cannot be listed */
ACMAP_EXPORT std::vector<std::string>
filesIn(const std::string& folder);

/** \brief Name of a picture, relative to the folder of the results: they have a folder
 * of their own. */
ACMAP_EXPORT std::string
pictureName(const std::string& name);

/** \brief Changes with the names, sizes and times of files; a missing file has only a
 * name. */
ACMAP_EXPORT std::string
stateOf(const std::string& folder, const std::vector<std::string>& names);

/** \brief The same for one file. */
ACMAP_EXPORT std::string
stateOfFile(const std::string& path);

} // namespace pcl::acmap
