#include "clouds/coordinate_shift.h"
#include "clouds/e57_cloud.h"
#include "clouds/point_cloud_readers.h"
#include "files/byte_source.h"

#include <vector>

namespace pcl::acmap {

PointCloudFile
readE57(ByteSource& source, LargeVector<std::uint8_t>* rows)
{
  E57Pages pages(source);
  pages.requireChecksums();
  const std::vector<E57Scan> scans = scansIn(pages);
  std::vector<Eigen::Isometry3d> T_map_scan;
  for (const E57Scan& scan : scans)
    T_map_scan.push_back(scan.T_map_scan);
  PointCloudFile file;
  CoordinateCheck check(true);
  setShift(readScans(scans, T_map_scan, {}, pages, rows, file.cloud, check), file);
  for (const Eigen::Isometry3d& pose : T_map_scan)
    file.viewpoints.push_back((pose.translation() - file.shift).cast<float>());
  file.sensor_origin = file.viewpoints.front();
  if (file.cloud.width == 0)
    file.remarks.emplace_back("its scans have no points");
  check.finish(file);
  return file;
}

} // namespace pcl::acmap
