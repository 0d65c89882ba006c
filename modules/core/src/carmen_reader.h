#pragma once

#include <pcl/core/carmen_log.h>

namespace pcl::acmap {

class ByteSource;

/** \brief The reader behind \ref loadCarmenLog, of a log that is not compressed.
 * \throws InputFileException naming line and fault */
CarmenLog
readCarmenLog(ByteSource& source);

} // namespace pcl::acmap
