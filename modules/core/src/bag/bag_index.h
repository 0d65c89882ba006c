#pragma once

#include "bag/bag_chunk.h"

#include <pcl/core/bag_file.h>

#include <vector>

namespace pcl::acmap {

/** \brief Channels, messages and chunks of a file of a bag, without the content of the
 * messages. */
struct BagIndex {
  std::vector<BagChannel> channels;
  std::vector<BagMessage> messages;
  std::vector<BagChunk> chunks;
};

/** \brief Reads a file in the format MCAP from its beginning to its end.
 * \throws InputFileException as \ref BagFile */
BagIndex
readMcapIndex(ByteSource& source);

/** \brief Reads a bag of ROS 1 from its beginning to its end.
 * \throws InputFileException as \ref BagFile */
BagIndex
readRos1Index(ByteSource& source);

} // namespace pcl::acmap
