#include "map_observations.h"

#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/core/carmen_log.h>

#include <algorithm>
#include <functional>

namespace pcl::acmap {

namespace {

/** Do the stamps increase? Some logs have the same stamp for all scans. */
bool
grow(const std::vector<double>& stamps)
{
  return std::adjacent_find(stamps.begin(), stamps.end(), std::greater_equal<>()) ==
         stamps.end();
}

void
useNumbersForStamps(Tool& tool, std::size_t every, std::vector<double>& stamps)
{
  for (std::size_t i = 0; i < stamps.size(); ++i)
    stamps[i] = static_cast<double>(i * every);
  tool.warn("the stamps of the log do not grow; the trajectory has the numbers of the "
            "scans instead");
}

} // namespace

MapObservations
readScans(Tool& tool, const std::string& log, std::size_t every)
{
  const CarmenLog carmen = loadCarmenLog(log);
  MapObservations observations;
  std::size_t beams = 0;
  for (std::size_t i = 0; i < carmen.scans.size(); i += every) {
    const PlanarScan& scan = carmen.scans[i];
    PlanarScanPoints echoes = pointsOf(scan);
    beams += scan.ranges.size();
    observations.points += echoes.cloud->size();
    observations.trajectory.stamps.push_back(scan.stamp);
    observations.trajectory.poses.push_back(isometryOf(scan.pose));
    observations.clouds.push_back(std::move(echoes.cloud));
    observations.weights.push_back(std::move(echoes.weights));
  }
  if (!grow(observations.trajectory.stamps))
    useNumbersForStamps(tool, every, observations.trajectory.stamps);
  const std::size_t missing = beams - observations.points;
  tool.tell("read",
            std::to_string(observations.clouds.size()) + " of " +
                std::to_string(carmen.scans.size()) + " scans, " +
                std::to_string(observations.points) + " echoes, " +
                std::to_string(missing) + " beams without");
  tool.details()["missing_beams"] = missing;
  observations.load = [clouds = observations.clouds](std::size_t i) {
    PointCloud<PointXYZ> echoes;
    copyPointCloud(*clouds[i], echoes);
    auto file = std::make_shared<PointCloudFile>();
    toPCLPointCloud2(echoes, file->cloud);
    return file;
  };
  return observations;
}

} // namespace pcl::acmap
