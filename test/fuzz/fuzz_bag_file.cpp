#include "bag/bag_index.h"
#include "files/byte_source.h"

#include <pcl/core/exceptions.h>

#include <cstdint>
#include <cstdlib>

namespace {

bool
isRos1(const std::uint8_t* data, std::size_t size)
{
  return size > 0 && data[0] == '#'; // of #ROSBAG
}

} // namespace

/** A bag is refused, or each of its messages is inside of its chunk or of the file. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace pcl::acmap;
  try {
    ByteSource source("input", data, size);
    const BagIndex index =
        isRos1(data, size) ? readRos1Index(source) : readMcapIndex(source);
    std::size_t messages = 0;
    for (const pcl::BagChannel& channel : index.channels)
      messages += channel.messages;
    if (messages != index.messages.size())
      std::abort();
    for (const pcl::BagMessage& message : index.messages) {
      const bool is_in_chunk = message.chunk >= 0;
      if (message.channel >= index.channels.size() ||
          (is_in_chunk &&
           static_cast<std::size_t>(message.chunk) >= index.chunks.size()))
        std::abort();
      const std::uint64_t bytes =
          is_in_chunk ? index.chunks[static_cast<std::size_t>(message.chunk)].bytes
                      : size;
      if (message.offset > bytes || message.bytes > bytes - message.offset)
        std::abort();
    }
    for (const BagChunk& chunk : index.chunks)
      if (readBagChunk(chunk, source).size() != chunk.bytes)
        std::abort();
  }
  catch (const pcl::InputFileException&) {
    return 0;
  }
  return 0;
}
