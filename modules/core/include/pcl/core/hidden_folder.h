#pragma once

#include <pcl/core/export.h>

#include <filesystem>
#include <string>

namespace pcl::acmap {

/** \brief A hidden folder for what is not whole yet: its owner renames files out of it into
 * place; what is left goes away with the object.
 *
 * The owner holds a lock on the folder, which ends with the process however that ends. So
 * whoever comes next can tell what a killed run left behind, and removes it.
 * \ingroup core */
class ACMAP_EXPORT HiddenFolder {
public:
  /** \brief Makes `.NAME.acmap-unfinished-N`, with the first number that is free, once
   * leftovers of this name are removed.
   * \param[in] parent folder to make it in; empty: the current one
   * \param[in] name of what it is for; may be empty
   * \param[in] shown what faults are told of, as the user wrote it
   * \throws OutputFileException when it cannot be made */
  HiddenFolder(const std::filesystem::path& parent,
               const std::string& name,
               const std::string& shown);

  /** \brief Removes it with what lies in it. */
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

/** \brief Whether a file name is one that a \ref HiddenFolder has. \ingroup core */
ACMAP_EXPORT bool
isHiddenFolderName(const std::string& name);

/** \brief Removes the hidden folders that killed runs left right in a folder. What cannot
 * be removed stays. \ingroup core */
ACMAP_EXPORT void
removeLeftoversIn(const std::string& folder);

/** \brief Removes those that were for a file or folder of this name. \ingroup core */
ACMAP_EXPORT void
removeLeftoversOf(const std::filesystem::path& parent, const std::string& name);

/** \brief A path without the hidden folders in it: where its file is to be. \ingroup core
 */
ACMAP_EXPORT std::string
shownPath(const std::string& path);

} // namespace pcl::acmap
