#pragma once

#include <pcl/core/bag_file.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

class ByteSource;

/** \brief Where a chunk of a bag is, and how it is packed. */
struct BagChunk {
  std::uint64_t offset = 0; ///< of its packed bytes in the file
  std::uint64_t packed_bytes = 0, bytes = 0;
  std::uint32_t checksum = 0; ///< of the unpacked bytes; 0: none
  std::string packing;
};

/** \brief Channels, messages and chunks of a bag, without the content of the messages. */
struct BagIndex {
  std::vector<BagChannel> channels;
  std::vector<BagMessage> messages;
  std::vector<BagChunk> chunks;
};

/** \brief Reads a bag from its beginning to its end.
 * \throws InputFileException as \ref BagFile */
BagIndex
readBagIndex(ByteSource& source);

/** \brief Reads and unpacks a chunk, and compares it with its checksum.
 * \throws InputFileException */
std::string
readBagChunk(const BagChunk& chunk, ByteSource& source);

} // namespace pcl::acmap
