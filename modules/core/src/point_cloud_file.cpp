#include <pcl/core/point_cloud_file.h>

#include "byte_source.h"
#include "file_ending.h"
#include "point_cloud_readers.h"

#include <algorithm>

namespace pcl {

acmap::PointView
PointCloudFile::points() const
{
  const auto x = std::find_if(cloud.fields.begin(),
                              cloud.fields.end(),
                              [](const auto& field) { return field.name == "x"; });
  if (x == cloud.fields.end() || cloud.data.empty())
    return {};
  return {cloud.data.data() + x->offset,
          cloud.point_step,
          std::size_t{cloud.width} * cloud.height};
}

PointCloudFile
loadPointCloud(const std::string& path)
{
  acmap::ByteSource source(path);
  const std::string ending = acmap::lowerEnding(path);
  if (ending == ".pcd")
    return acmap::readPcd(source);
  if (ending == ".ply")
    return acmap::readPly(source);
  if (ending == ".obj")
    return acmap::readObj(source);
  if (ending == ".xyz")
    return acmap::readXyz(source);
  source.fail("ending '" + ending + "' is not known; pcd, ply, obj and xyz are");
}

} // namespace pcl
