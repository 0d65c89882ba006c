#pragma once

#include <pcl/core/export.h>
#include <pcl/core/hidden_folder.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A folder of results that appear all together: files are written into a
 * \ref HiddenFolder, inside of it or, where it is new, beside it, and \ref commit renames
 * them into place. A run that fails before leaves the folder as it was, a killed one what
 * the next one for this folder removes. \ingroup core */
class ACMAP_EXPORT OutputFolder {
public:
  /** \brief Makes the folder where it is missing; what it lies in must be there. Removes
   * what killed runs left.
   * \throws OutputFileException when it cannot be made or written to */
  explicit OutputFolder(const std::string& path);

  /** \brief Removes what was not committed. */
  ~OutputFolder();

  OutputFolder(const OutputFolder&) = delete;
  OutputFolder&
  operator=(const OutputFolder&) = delete;

  /** \brief As the user wrote it. */
  const std::string&
  name() const
  {
    return name_;
  }

  /** \brief Where to write a file of this name until \ref commit. */
  std::string
  path(const std::string& name) const;

  /** \brief Names of what lies in it, in order, hidden folders of runs apart; of nothing
   * that this run wrote.
   * \throws OutputFileException when it cannot be listed */
  std::vector<std::string>
  names() const;

  /** \brief Whether a path, existing or not, names a file right in this folder. */
  bool
  holds(const std::string& path) const;

  /** \brief Puts what was written into place: a new folder that is empty by then all at
   * once, else file by file. Where such a rename fails midway, new files stand beside old
   * ones, and those that are left are removed. A name that belongs to a folder is
   * foreseen: then nothing is put into place.
   * \throws OutputFileException when a file could not be put into place */
  void
  commit();

private:
  /** \brief Makes the hidden folder. */
  void
  hide();

  /** \brief Renames them one by one. */
  void
  putFilesInPlace() const;

  std::string name_;
  std::filesystem::path folder_;
  std::optional<HiddenFolder> hidden_;
  std::filesystem::path files_; // in there
  bool made_ = false;
};

} // namespace pcl::acmap
