#include "files/carmen_reader.h"
#include "source_checks.h"

#include <cmath>

using namespace pcl::acmap;

/** Bytes are rejected, or give valid scans, which are converted to points. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const auto read = [](ByteSource& source) { return readCarmenLog(source); };
  const auto log = test::acceptedBy(read, data, size);
  if (!log)
    return 0;
  test::require(!log->scans.empty());
  for (const pcl::PlanarScan& scan : log->scans) {
    test::require(scan.ranges.size() >= 2 && 2 * scan.ranges.size() < size);
    test::require(std::isfinite(scan.stamp) && std::isfinite(scan.pose.x) &&
                  std::isfinite(scan.pose.z) && std::isfinite(scan.pose.theta));
    test::require(scan.maximum_range >= 0 && std::isfinite(scan.first_angle) &&
                  std::isfinite(scan.angle_step));
    const pcl::PlanarScanPoints points = pcl::pointsOf(scan);
    test::require(points.cloud->size() == points.weights.size());
    test::require(points.cloud->size() + points.missing_beams == scan.ranges.size());
    for (const pcl::PointNormal& point : *points.cloud)
      test::require(std::isfinite(point.x) && point.y == 0 && std::isfinite(point.z));
  }
  return 0;
}
