#pragma once

#include <pcl/core/compact_map.h>

#include <functional>
#include <string>

namespace pcl::acmap {

class ByteSource;

/** \brief The reader behind \ref loadMapFile.
 * \param[in] name stands for the file in messages, as that of the source
 * \throws InputFileException naming file and fault */
CompactMap
readMap(const std::string& name, ByteSource& source);

/** \brief Gives what \ref saveMapFile writes, a piece at a time: all is never held twice.
 * \throws BadArgumentException likewise */
void
writeMap(const CompactMap& map, const std::function<void(const std::string&)>& write);

} // namespace pcl::acmap
