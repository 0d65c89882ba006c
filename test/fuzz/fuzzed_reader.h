#pragma once

#include "files/byte_source.h"
#include "files/record_moves.h"

#include <pcl/core/point_cloud_file.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace pcl::acmap::test {

/** \brief Runs a reader on bytes: it must reject them, or give a cloud whose fields and
 * points are all inside its data. */
template <typename Reader>
int
readFuzzed(const std::uint8_t* data, std::size_t size, const Reader& reader)
{
  try {
    ByteSource source("input", data, size);
    const PointCloudFile file = reader(source);
    const PCLPointCloud2& cloud = file.cloud;
    if (cloud.data.size() != file.points().size() * cloud.point_step)
      std::abort();
    for (const PCLPointField& field : cloud.fields)
      if (field.offset + sizeOfType(field.datatype) * field.count > cloud.point_step)
        std::abort();
    for (std::size_t i = 0; i < file.points().size(); ++i)
      if (cloud.is_dense && !file.points()[i].allFinite())
        std::abort();
  }
  catch (const InputFileException&) {
    return 0;
  }
  return 0;
}

} // namespace pcl::acmap::test
