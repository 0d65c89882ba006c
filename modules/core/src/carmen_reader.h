#pragma once

#include <pcl/core/carmen_log.h>

namespace pcl::acmap {

class ByteSource;

/** \brief Implementation of \ref loadCarmenLog for an uncompressed log.
 * \throws InputFileException naming line and fault */
CarmenLog
readCarmenLog(ByteSource& source);

} // namespace pcl::acmap
