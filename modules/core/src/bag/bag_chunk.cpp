#include "bag/bag_chunk.h"
#include "bag/chunk_unpacking.h"
#include "files/byte_source.h"

#include <zlib.h>

#include <algorithm>

namespace pcl::acmap {

std::uint32_t
bagChecksum(std::string_view bytes, std::uint32_t before)
{
  uLong sum = before;
  while (!bytes.empty()) { // zlib counts in 32 bits
    const std::size_t part = std::min(bytes.size(), std::size_t{1} << 30);
    sum = ::crc32(
        sum, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(part));
    bytes.remove_prefix(part);
  }
  return static_cast<std::uint32_t>(sum);
}

std::string
unpackBagChunk(const BagChunk& chunk, std::string_view packed, const ByteSource& source)
{
  const auto fail = [&](const std::string& fault) {
    source.fail("its chunk at byte " + std::to_string(chunk.offset) + " " + fault);
  };
  // what real data can be packed to; a chunk of zeros could claim any size
  constexpr std::uint64_t max_expansion = 450, always = std::uint64_t{1} << 23;
  if (chunk.bytes > std::max(always, max_expansion * packed.size()))
    fail("claims " + std::to_string(chunk.bytes) + " bytes, packed to " +
         std::to_string(packed.size()));
  std::string bytes = unpackChunk(chunk.packing, packed, chunk.bytes, fail);
  if (chunk.checksum != 0 && bagChecksum(bytes) != chunk.checksum)
    fail("is damaged: its checksum is wrong");
  return bytes;
}

std::string
readBagChunk(const BagChunk& chunk, ByteSource& source)
{
  source.moveTo(chunk.offset);
  if (chunk.packed_bytes > source.remaining())
    source.fail("became shorter while it was read");
  std::string packed(chunk.packed_bytes, '\0');
  source.read(packed.data(), packed.size());
  return unpackBagChunk(chunk, packed, source);
}

} // namespace pcl::acmap
