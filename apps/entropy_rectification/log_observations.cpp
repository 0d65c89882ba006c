#include "log_observations.h"

#include <pcl/core/carmen_log.h>
#include <pcl/pipeline/bag_scans.h>
#include <pcl/pipeline/input_kind.h>

#include <cmath>
#include <utility>

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

LaserObservations
readScans(const RectificationOptions& options, StageLog& log)
{
  std::vector<PlanarScan> all = allScans(options, log);
  const std::size_t scans = all.size();
  LaserObservations observations = observationsOf(std::move(all), options.bag.every);
  log.warn(observations.remarks);
  log.tell("read",
           std::to_string(observations.clouds.size()) + " of " + std::to_string(scans) +
               " scans, " + std::to_string(observations.points) + " echoes, " +
               std::to_string(observations.missing_beams) + " beams without");
  log.details["missing_beams"] = observations.missing_beams;
  return observations;
}

} // namespace pcl::acmap
