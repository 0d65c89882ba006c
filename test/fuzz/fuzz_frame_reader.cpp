#include "session/frame_codec.h"
#include "session/little_endian.h"

#include <pcl/core/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace {

/** Bytes are rejected, or give a frame that can be written and read again. */
void
read(const std::vector<std::uint8_t>& bytes)
{
  try {
    const pcl::TrinocularFrame frame = pcl::acmap::decodeFrame("input", bytes);
    const auto again = pcl::acmap::decodeFrame("again", pcl::acmap::encodeFrame(frame));
    if (!(again.images == frame.images) || again.number != frame.number)
      std::abort();
  }
  catch (const pcl::InputFileException&) {
    return;
  }
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::vector<std::uint8_t> bytes(data, data + size);
  read(bytes);
  // Sets a valid checksum, which a fuzzer does not find, to reach the code behind it.
  if (size >= sizeof(std::uint32_t)) {
    const std::size_t checked = size - sizeof(std::uint32_t);
    std::uint8_t* end = bytes.data() + checked;
    pcl::acmap::putNumber(end, pcl::acmap::checksumOf(bytes.data(), checked));
    read(bytes);
  }
  return 0;
}
