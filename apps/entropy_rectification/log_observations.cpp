#include "log_observations.h"

#include "input_kind.h"

#include <pcl/core/carmen_log.h>
#include <pcl/pipeline/bag_scans.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

std::string
degreesText(double radians)
{
  return shortNumber(radians * 180 / M_PI) + " degrees";
}

/** \brief The scans of a log, with what is assumed of their angles. */
std::vector<PlanarScan>
scansOfLog(const RectificationOptions& options, StageLog& log)
{
  CarmenLog carmen = loadCarmenLog(options.log, options.laser_sweep);
  log.warn(carmen.remarks);
  const PlanarScan& first = carmen.scans.front();
  const std::string step = ", a beam each " + degreesText(std::abs(first.angle_step));
  if (carmen.sweep == 0)
    log.tell("sweep",
             degreesText(std::abs(first.angle_step) *
                         static_cast<double>(first.ranges.size() - 1)) +
                 step + ", as the log states");
  else
    log.tell("sweep",
             degreesText(carmen.sweep) + step +
                 (carmen.is_sweep_stated ? ", as stated"
                                         : ", assumed; --laser-fov states another"));
  return std::move(carmen.scans);
}

std::vector<PlanarScan>
allScans(const RectificationOptions& options, StageLog& log)
{
  if (inputKindOf(options.log) != InputKind::Bag)
    return scansOfLog(options, log);
  BagSettings settings = options.bag;
  settings.every = 1;
  BagScans read = loadBagScans(options.log, settings);
  log.warn(read.remarks);
  return std::move(read.scans);
}

} // namespace

LogObservations
readScans(const RectificationOptions& options, StageLog& log)
{
  LogObservations observations;
  std::vector<PlanarScan> all = allScans(options, log);
  std::vector<double>& stamps = observations.trajectory.stamps;
  std::size_t beams = 0;
  for (std::size_t i = 0; i < all.size(); i += options.bag.every) {
    const PlanarScan& scan = all[i];
    PlanarScanPoints echoes = pointsOf(scan);
    beams += scan.ranges.size();
    observations.points += echoes.cloud->size();
    stamps.push_back(scan.stamp);
    observations.trajectory.poses.push_back(isometryOf(scan.pose));
    observations.clouds.push_back(std::move(echoes.cloud));
    observations.weights.push_back(std::move(echoes.weights));
    observations.scans.push_back(std::move(all[i]));
  }
  // some logs have the same stamp for all scans
  if (std::adjacent_find(stamps.begin(), stamps.end(), std::greater_equal<>()) !=
      stamps.end()) {
    for (std::size_t i = 0; i < stamps.size(); ++i)
      stamps[i] = static_cast<double>(i * options.bag.every);
    log.warn("the stamps of the log do not grow; the trajectory has the numbers of the "
             "scans instead");
  }
  const std::size_t missing = beams - observations.points;
  log.tell("read",
           std::to_string(observations.clouds.size()) + " of " +
               std::to_string(all.size()) + " scans, " +
               std::to_string(observations.points) + " echoes, " +
               std::to_string(missing) + " beams without");
  log.details["missing_beams"] = missing;
  return observations;
}

} // namespace pcl::acmap
