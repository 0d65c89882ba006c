#include "map_observations.h"

#include "fields_json.h"
#include "length_check.h"

#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/core/carmen_log.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

MapObservations
readObservations(const ObservationSequence& sequence,
                 bool raw,
                 bool skip_broken,
                 const RunControls& controls,
                 StageLog& log)
{
  SequenceConsolidation consolidation;
  consolidation.setRawPoints(raw);
  consolidation.setSkipBroken(skip_broken);
  consolidation.setNumberOfThreads(controls.threads);
  consolidation.setProgressCallback(controls.progress);
  MapObservations observations;
  consolidation.compute(sequence, observations);
  const SequenceConsolidationReport& report = consolidation.getReport();
  if (observations.places.front() == 0)
    warnOfLengths(sequence.load(0).file->points(), controls, log);
  log.warn(report.remarks);
  log.tell("read",
           std::to_string(observations.places.size()) + " observations, " +
               std::to_string(report.points) + " points");
  log.tell("consolidated",
           raw ? "no, the paper takes raw points"
               : "to " + std::to_string(report.representatives) + ", voxels of " +
                     shortNumber(report.min_voxel_size) + " to " +
                     shortNumber(report.max_voxel_size) + " m");
  log.details["consolidated_points"] = report.representatives;
  log.details["consolidation"] = fieldsOf(report, {{"points"}, {"colored"}});
  for (const std::size_t place : observations.places)
    observations.files.push_back(sequence.name(place));
  observations.load = [sequence, places = observations.places](std::size_t i) {
    return sequence.load(places[i]).file;
  };
  observations.points = report.points;
  observations.colored = report.colored;
  return observations;
}

MapObservations
readScans(const std::string& path, std::size_t every, StageLog& log)
{
  const CarmenLog carmen = loadCarmenLog(path);
  MapObservations observations;
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
