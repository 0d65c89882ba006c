#include "clouds/coordinate_shift.h"
#include "clouds/e57_cloud.h"
#include "clouds/point_cloud_readers.h"
#include "files/byte_source.h"

#include <vector>

namespace pcl::acmap {

namespace {

/** The scans of a file in its frame, as one cloud. */
PointCloudFile
readAll(ScanReader& reader,
        LargeVector<std::uint8_t>* rows,
        const CloudStatement& stated)
{
  const std::vector<E57Scan> scans = reader.scans();
  PointCloudFile file;
  std::vector<Eigen::Isometry3d> T_map_scan;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (const E57Scan& scan : scans) {
    T_map_scan.push_back(scan.T_map_scan);
    if (!scan.remark.empty())
      file.remarks.push_back(scan.remark);
    if (shift.isZero(0))
      shift = shiftOf(scan, scan.T_map_scan, stated, reader);
  }
  setShift(shift, stated, file);
  CoordinateCheck check(true, stated.scale);
  check.setShift(shift);
  readScans(scans, T_map_scan, shift, reader, rows, file.cloud, check);
  for (const Eigen::Isometry3d& pose : T_map_scan)
    file.viewpoints.push_back((pose.translation() - file.shift).cast<float>());
  file.sensor_origin = file.viewpoints.front();
  if (file.cloud.width == 0)
    file.remarks.emplace_back("its scans have no points");
  check.finish(file);
  return file;
}

} // namespace

PointCloudFile
readE57(ByteSource& source,
        LargeVector<std::uint8_t>* rows,
        const CloudStatement& stated)
{
  return readAll(*readerOfE57(source, true), rows, stated);
}

PointCloudFile
readPtx(ByteSource& source,
        LargeVector<std::uint8_t>* rows,
        const CloudStatement& stated)
{
  return readAll(*readerOfPtx(source), rows, stated);
}

} // namespace pcl::acmap
