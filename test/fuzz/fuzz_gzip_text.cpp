#include "files/carmen_reader.h"
#include "source_checks.h"

using namespace pcl::acmap;

/** Bytes are rejected, or unpack to at most the maximum size that deflate can
 * achieve. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const auto text = test::acceptedBy(unpackGzip, data, size);
  test::require(!text || text->size() <= 1032 * size);
  return 0;
}
