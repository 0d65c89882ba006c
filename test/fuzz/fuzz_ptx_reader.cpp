#include "fuzzed_reader.h"

#include "clouds/point_cloud_readers.h"

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  return pcl::acmap::test::readFuzzed(data, size, [](pcl::acmap::ByteSource& source) {
    return pcl::acmap::readPtx(source);
  });
}
