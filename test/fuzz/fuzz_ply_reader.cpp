#include "clouds/mesh_codecs.h"
#include "clouds/point_cloud_readers.h"
#include "fuzzed_reader.h"

namespace {

void
readFacesFuzzed(const std::uint8_t* data, std::size_t size)
{
  try {
    pcl::acmap::ByteSource source("input", data, size);
    pcl::acmap::readPlyFaces(source);
  }
  catch (const pcl::InputFileException&) {
    return;
  }
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  readFacesFuzzed(data, size);
  return pcl::acmap::test::readFuzzed(data, size, [](pcl::acmap::ByteSource& source) {
    return pcl::acmap::readPly(source);
  });
}
