#include "map_observations.h"

#include "length_check.h"

#include <pcl/core/cloud_fields.h>
#include <pcl/core/noise_scale.h>
#include <pcl/filters/consolidation_kernel.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

/** Smaller ones would make the work long and the map no straighter. */
constexpr double least_voxel = 0.05; // metres

struct Counts {
  std::size_t representatives = 0;
  double least = 0, largest = 0; ///< voxel, metres
};

std::size_t
finitePoints(const PointView& points)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    count += points[i].allFinite() ? 1 : 0;
  return count;
}

PointCloud<PointNormal>::Ptr
cloudOf(const std::vector<Representative>& representatives)
{
  PointCloud<PointNormal>::Ptr cloud(new PointCloud<PointNormal>);
  for (const Representative& representative : representatives) {
    PointNormal point;
    point.getVector3fMap() = representative.point;
    point.getNormalVector3fMap() = representative.normal;
    point.curvature = representative.curvature;
    cloud->push_back(point);
  }
  return cloud;
}

void
count(const ConsolidationReport& report, Counts& counts)
{
  if (report.representatives == 0)
    return;
  counts.representatives += report.representatives;
  counts.largest = std::max(counts.largest, report.voxel_size);
  counts.least =
      counts.least > 0 ? std::min(counts.least, report.voxel_size) : report.voxel_size;
}

void
consolidate(const std::string& path,
            const PointView& points,
            unsigned threads,
            const Progress& progress,
            MapObservations& observations,
            Counts& counts)
{
  const SensorView sensor(Eigen::Vector3f::Zero());
  ConsolidationSettings settings;
  settings.threads = threads;
  settings.voxel_size =
      std::max(least_voxel, automaticVoxel(measureNoiseScale(points, sensor, threads)));
  ConsolidationReport report;
  const Consolidation consolidation =
      consolidatePoints(points, sensor, ColorView(), settings, progress, report);
  observations.clouds.push_back(cloudOf(consolidation.representatives));
  const double edges = report.voxel_size / least_voxel;
  const auto weight = static_cast<float>(edges * edges);
  if (!std::isfinite(weight))
    throw InputFileException(path + ": its points are " +
                             shortNumber(report.voxel_size) +
                             " m apart: these cannot be metres");
  observations.weights.emplace_back(consolidation.representatives.size(), weight);
  count(report, counts);
}

/** \brief Counts an observation. \return its finite points */
std::size_t
add(const ObservationSequence& sequence,
    std::size_t i,
    const PosedObservation& seen,
    MapObservations& observations)
{
  const std::size_t points = finitePoints(seen.file->points());
  observations.points += points;
  observations.colored = observations.colored || findColor(seen.file->cloud);
  observations.files.push_back(sequence.name(i));
  observations.trajectory.stamps.push_back(sequence.stamp(i));
  observations.trajectory.poses.push_back(seen.T_map_camera);
  return points;
}

void
tellCounts(Tool& tool, const MapObservations& observations, const Counts& counts)
{
  tool.tell("read",
            std::to_string(observations.clouds.size()) + " observations, " +
                std::to_string(observations.points) + " points");
  tool.tell("consolidated",
            "to " + std::to_string(counts.representatives) + ", voxels of " +
                shortNumber(counts.least) + " to " + shortNumber(counts.largest) +
                " m");
  tool.details()["consolidation"] = {{"representatives", counts.representatives},
                                     {"least_voxel", counts.least},
                                     {"largest_voxel", counts.largest}};
}

/** Poses that were rectified before differ from all VIEWPOINTs: one line will do. */
void
warnOf(Tool& tool, const std::vector<std::string>& remarks)
{
  if (remarks.empty())
    return;
  const std::size_t others = remarks.size() - 1;
  tool.warn(remarks.front() +
            (others > 0 ? "; and " + std::to_string(others) + " further files likewise"
                        : ""));
}

} // namespace

MapObservations
readObservations(Tool& tool, const ObservationSequence& sequence, bool skip_broken)
{
  MapObservations observations;
  std::vector<std::size_t> places; // in the folder
  Counts counts;
  std::vector<std::string> remarks;
  tool.withProgress([&](const ProgressCallback& callback) {
    const Progress progress(callback);
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      progress.tell(static_cast<double>(i) / static_cast<double>(sequence.size()),
                    "reading");
      try {
        const PosedObservation seen = sequence.load(i);
        remarks.insert(remarks.end(), seen.remarks.begin(), seen.remarks.end());
        if (i == 0)
          warnOfLengths(tool, *seen.file);
        if (add(sequence, i, seen, observations) == 0)
          tool.warn(sequence.path(i) + ": has no point");
        consolidate(sequence.path(i),
                    seen.file->points(),
                    tool.threads(),
                    Progress(),
                    observations,
                    counts);
        places.push_back(i);
      }
      catch (const InputFileException& error) {
        if (!skip_broken)
          throw;
        tool.warn("left out: " + std::string(error.what()));
      }
    }
  });
  warnOf(tool, remarks);
  for (const std::string& remark : sequence.remarks())
    tool.warn(remark);
  if (places.empty())
    throw InputFileException("none of the observations can be read");
  sequence.requireDifferent(observations.trajectory.poses);
  observations.load = [sequence, places](std::size_t i) {
    return sequence.load(places[i]).file;
  };
  tellCounts(tool, observations, counts);
  return observations;
}

} // namespace pcl::acmap
