#pragma once

#include <pcl/core/carmen_log.h>

#include <optional>
#include <string>

namespace pcl::acmap {

class ByteSource;

/** \brief Implementation of \ref loadCarmenLog for an uncompressed log.
 * \throws InputFileException naming line and fault */
CarmenLog
readCarmenLog(ByteSource& source, std::optional<double> sweep = {});

/** \brief Returns true if the first bytes of a file are those of a gzip file.
 * \throws InputFileException when it is missing, unreadable, empty or not a regular
 * file */
bool
isGzip(const std::string& path);

/** \brief Decompresses the rest of a source, with all its members.
 * \throws InputFileException when it is truncated or damaged, or decompresses to more
 * than 1 GiB: a thousand bytes may expand to a million */
std::string
unpackGzip(ByteSource& source);

} // namespace pcl::acmap
