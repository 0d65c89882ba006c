#pragma once

#include <pcl/core/export.h>

#include <filesystem>
#include <string>

namespace pcl::acmap {

/** \brief A hidden folder for incomplete files. Its owner renames files from it to
 * their final paths; the folder and its remaining files are removed by the destructor.
 *
 * The owner holds a lock on the folder, which is released when the process ends for any
 * reason. The next process can therefore detect and remove what a killed process left
 * behind.
 * \ingroup core */
class ACMAP_EXPORT HiddenFolder {
public:
  /** \brief Removes leftovers of this name and creates `.NAME.acmap-unfinished-N`, with
   * the first free number.
   * \param[in] parent folder to create it in; empty for the current one
   * \param[in] name name of the final file or folder; may be empty
   * \param[in] shown path in error messages, as given by the user
   * \throws OutputFileException when it cannot be created */
  HiddenFolder(const std::filesystem::path& parent,
               const std::string& name,
               const std::string& shown);

  /** \brief Removes the folder and its contents. */
  ~HiddenFolder();

  HiddenFolder(const HiddenFolder&) = delete;
  HiddenFolder&
  operator=(const HiddenFolder&) = delete;

  const std::filesystem::path&
  path() const
  {
    return path_;
  }

private:
  std::filesystem::path path_;
  int lock_ = -1;
};

/** \brief Returns true if a file name is the name of a \ref HiddenFolder. \ingroup core
 */
ACMAP_EXPORT bool
isHiddenFolderName(const std::string& name);

/** \brief Removes the hidden folders that killed processes left in a folder, not
 * recursively. Those that cannot be removed are kept. \ingroup core */
ACMAP_EXPORT void
removeLeftoversIn(const std::string& folder);

/** \brief Removes the leftovers for a file or folder of this name. \ingroup core */
ACMAP_EXPORT void
removeLeftoversOf(const std::filesystem::path& parent, const std::string& name);

/** \brief Removes hidden folders from a path, which gives the final path of the file.
 * \ingroup core */
ACMAP_EXPORT std::string
shownPath(const std::string& path);

} // namespace pcl::acmap
