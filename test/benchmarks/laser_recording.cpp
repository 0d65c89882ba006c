#include "laser_recording.h"

#include "bench_data.h"

#include <pcl/conversions.h>
#include <pcl/core/trajectory.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

std::optional<ObservationSequence>
loadLaserScans()
{
  constexpr float unit = 1.0F / 500; // metres
  const std::string folder = "C_sequence/livox_scans_60";
  const std::optional<std::string> path = pathOfData(folder + "/trajectory.txt");
  if (!path)
    return std::nullopt;
  const Trajectory trajectory = loadTrajectory(*path);
  std::vector<std::shared_ptr<const PointCloudFile>> clouds;
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
    const std::string number = std::to_string(i);
    const PointCloudFile scan = loadMaybePacked(
        pathOfData(folder + "/scan_" + std::string(3 - number.size(), '0') + number +
                   ".ply.xz")
            .value());
    PointCloud<PointXYZ> metres;
    const PointView points = scan.points();
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Eigen::Vector3f point = unit * points[k];
      metres.push_back({point.x(), point.y(), point.z()});
    }
    const auto cloud = std::make_shared<PointCloudFile>();
    toPCLPointCloud2(metres, cloud->cloud);
    clouds.push_back(cloud);
  }
  return ObservationSequence(std::move(clouds), trajectory);
}

} // namespace pcl::acmap::bench
