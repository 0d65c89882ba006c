#pragma once

#include <pcl/core/export.h>

#include <filesystem>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A folder of results that appear all together: files are written into a hidden
 * folder inside of it, and \ref commit renames them into place. A run that fails before
 * leaves the folder as it was; a killed one leaves its hidden folder behind, which later
 * runs do not touch. \ingroup core */
class ACMAP_EXPORT OutputFolder {
public:
  /** \brief Makes the folder where it is missing; what it lies in must be there.
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

  /** \brief Names of what lies in it, in order; of nothing that this run wrote.
   * \throws OutputFileException when it cannot be listed */
  std::vector<std::string>
  names() const;

  /** \brief Whether a path, existing or not, names a file right in this folder. */
  bool
  holds(const std::string& path) const;

  /** \brief Renames what was written into place, file by file: where a rename fails
   * midway, new files stand beside old ones, and the hidden ones that are left are removed.
   * A name that belongs to a folder is foreseen: then nothing is put into place.
   * \throws OutputFileException when a file could not be put into place */
  void
  commit();

private:
  std::string name_;
  std::filesystem::path folder_;
  std::filesystem::path hidden_;
  bool made_ = false;
};

} // namespace pcl::acmap
