#include "log_observations.h"

#include <pcl/core/carmen_log.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

LogObservations
readScans(const std::string& path, std::size_t every, StageLog& log)
{
  const CarmenLog carmen = loadCarmenLog(path);
  LogObservations observations;
  std::vector<double>& stamps = observations.trajectory.stamps;
  std::size_t beams = 0;
  for (std::size_t i = 0; i < carmen.scans.size(); i += every) {
    const PlanarScan& scan = carmen.scans[i];
    PlanarScanPoints echoes = pointsOf(scan);
    beams += scan.ranges.size();
    observations.points += echoes.cloud->size();
    stamps.push_back(scan.stamp);
    observations.trajectory.poses.push_back(isometryOf(scan.pose));
    observations.clouds.push_back(std::move(echoes.cloud));
    observations.weights.push_back(std::move(echoes.weights));
    observations.scans.push_back(scan);
  }
  // some logs have the same stamp for all scans
  if (std::adjacent_find(stamps.begin(), stamps.end(), std::greater_equal<>()) !=
      stamps.end()) {
    for (std::size_t i = 0; i < stamps.size(); ++i)
      stamps[i] = static_cast<double>(i * every);
    log.warn("the stamps of the log do not grow; the trajectory has the numbers of the "
             "scans instead");
  }
  const std::size_t missing = beams - observations.points;
  log.tell("read",
           std::to_string(observations.clouds.size()) + " of " +
               std::to_string(carmen.scans.size()) + " scans, " +
               std::to_string(observations.points) + " echoes, " +
               std::to_string(missing) + " beams without");
  log.details["missing_beams"] = missing;
  return observations;
}

} // namespace pcl::acmap
