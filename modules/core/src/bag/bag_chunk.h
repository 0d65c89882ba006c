#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace pcl::acmap {

class ByteSource;

/** \brief Where a chunk of a bag is, and how it is packed. */
struct BagChunk {
  std::uint64_t offset = 0; ///< of its packed bytes in the file
  std::uint64_t packed_bytes = 0, bytes = 0;
  std::uint32_t checksum = 0; ///< of the unpacked bytes; 0: none
  std::string packing;        ///< as \ref unpackChunk names it
};

/** \brief CRC-32 of bytes that follow others.
 * \param[in] before checksum of the others */
std::uint32_t
bagChecksum(std::string_view bytes, std::uint32_t before = 0);

/** \brief Unpacks a chunk, and compares it with its checksum.
 * \param[in] source names the file in messages
 * \throws InputFileException */
std::string
unpackBagChunk(const BagChunk& chunk,
               std::string_view packed,
               const ByteSource& source);

/** \brief Reads and unpacks a chunk, and compares it with its checksum.
 * \throws InputFileException */
std::string
readBagChunk(const BagChunk& chunk, ByteSource& source);

} // namespace pcl::acmap
