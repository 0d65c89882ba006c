#pragma once

#include <string>

namespace pcl::acmap {

class ByteSource;

/** \brief Tells by its first bytes whether a file is compressed by gzip.
 * \throws InputFileException when it is missing, unreadable, empty or no file */
bool
isGzip(const std::string& path);

/** \brief Unpacks the rest of a source, all its members.
 * \throws InputFileException when it is truncated or damaged, or unpacks to more than
 * 1 GiB: a thousand bytes may stand for a million */
std::string
unpackGzip(ByteSource& source);

} // namespace pcl::acmap
