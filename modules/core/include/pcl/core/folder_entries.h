#pragma once

#include <pcl/core/export.h>

#include <filesystem>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief What lies right in a folder, in the order of the names; O(n log n).
 * \param[in] folder to list
 * \return paths that begin with \a folder
 * \throws InputFileException when it cannot be listed
 * \throws std::bad_alloc when memory is what is missing
 * \ingroup core */
ACMAP_EXPORT std::vector<std::filesystem::path>
folderEntries(const std::string& folder);

} // namespace pcl::acmap
