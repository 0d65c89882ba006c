#pragma once

#include <pcl/core/export.h>

#include <filesystem>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Lists the entries of a folder, not recursively, sorted by name; O(n log n).
 * \param[in] folder to list
 * \return paths that begin with \a folder
 * \throws InputFileException when it cannot be listed
 * \throws std::bad_alloc when there is not enough memory
 * \ingroup core */
ACMAP_EXPORT std::vector<std::filesystem::path>
folderEntries(const std::string& folder);

/** \brief Does a file name, which may come from anybody's file, stay in its folder?
 * \ingroup core */
inline bool
isPlainName(const std::string& name)
{
  return !name.empty() && name != "." && name != ".." &&
         name.find_first_of(std::string("/\0", 2)) == std::string::npos;
}

} // namespace pcl::acmap
