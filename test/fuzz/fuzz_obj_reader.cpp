#include "clouds/mesh_codecs.h"
#include "clouds/point_cloud_readers.h"
#include "fuzzed_reader.h"
#include "source_checks.h"

using namespace pcl::acmap;

/** Corners of faces are valid indices of vertices in the cloud. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const auto read = [](ByteSource& source) { return readObj(source); };
  test::readFuzzed(data, size, read);
  const auto mesh = test::acceptedBy(readObjFaces, data, size);
  const auto file = test::acceptedBy(read, data, size);
  if (mesh && file) {
    const std::size_t points = file->points().size();
    test::require(mesh->wall_depth.empty());
    for (const pcl::TriangleMesh::Triangle& triangle : mesh->triangles)
      for (const std::int32_t corner : triangle)
        test::require(corner >= 0 && static_cast<std::size_t>(corner) < points);
  }
  return 0;
}
