#pragma once

#include <pcl/core/compact_map.h>

#include <functional>
#include <string>

namespace pcl::acmap {

class ByteSource;

/** \brief Implementation of \ref loadMapFile.
 * \param[in] name file name in messages
 * \param[in] source the contents of the file
 * \throws InputFileException naming file and fault */
CompactMap
readMap(const std::string& name, ByteSource& source);

/** \brief Passes the output of \ref saveMapFile to a function in several pieces, so
 * that there is no second copy of the whole map in memory.
 * \throws BadArgumentException as \ref saveMapFile */
void
writeMap(const CompactMap& map, const std::function<void(const std::string&)>& write);

} // namespace pcl::acmap
