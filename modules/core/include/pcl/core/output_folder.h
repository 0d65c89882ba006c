#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/hidden_folder.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A folder whose result files appear together, also those in folders of it that
 * the caller creates at \ref path. Files are written into a HiddenFolder, which is inside of the folder or, if the folder is new, beside it;
 * \ref commit renames them to their final paths. If the process fails before, the
 * folder is unchanged. The leftovers of a killed process are removed by the next
 * process that writes to this folder. \ingroup core */
class ACMAP_EXPORT OutputFolder {
public:
  /** \brief Creates the folder if it does not exist; its parent must exist. Removes
   * leftovers of killed processes.
   * \throws OutputFileException when it cannot be created or written to */
  explicit OutputFolder(const std::string& path);

  /** \brief Removes files that were not committed. */
  ~OutputFolder();

  OutputFolder(const OutputFolder&) = delete;
  OutputFolder&
  operator=(const OutputFolder&) = delete;

  /** \brief The path as given by the user. */
  const std::string&
  name() const
  {
    return name_;
  }

  /** \brief Path to which a file of this name is written before \ref commit. */
  std::string
  path(const std::string& name) const;

  /** \brief Names of the entries of the folder in order, without hidden folders and
   * without uncommitted files.
   * \throws OutputFileException when it cannot be listed */
  std::vector<std::string>
  names() const;

  /** \brief Returns true if a path, existing or not, is a file directly in this folder.
   */
  bool
  holds(const std::string& path) const;

  /** \brief Puts the written files into place. If the folder is new and still empty,
   * this is done in one step, otherwise file by file. If a rename fails, some files are
   * new and others old, and the remaining new files are removed. If the name of a file
   * is used by a folder, this is detected beforehand and no file is put into place.
   * \throws OutputFileException when a file could not be put into place */
  void
  commit();

private:
  /** \brief Creates the hidden folder. */
  void
  hide();

  /** \brief Renames the files one by one. */
  void
  putFilesInPlace() const;

  std::string name_;
  std::filesystem::path folder_;
  std::optional<HiddenFolder> hidden_;
  std::filesystem::path files_; // folder of the files before commit
  bool made_ = false;
};

} // namespace pcl::acmap
