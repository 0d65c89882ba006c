#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/noise_scale.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/pipeline/sequence_consolidation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace pcl {

namespace {

constexpr double min_voxel = 0.05; // metres

PointCloud<PointNormal>::Ptr
finitePoints(const acmap::PointView& points)
{
  PointCloud<PointNormal>::Ptr cloud(new PointCloud<PointNormal>);
  for (std::size_t i = 0; i < points.size(); ++i) {
    PointNormal point;
    point.getVector3fMap() = points[i];
    point.getNormalVector3fMap().setConstant(std::numeric_limits<float>::quiet_NaN());
    if (point.getVector3fMap().allFinite())
      cloud->push_back(point);
  }
  return cloud;
}

void
count(const ConsolidationReport& consolidation, SequenceConsolidationReport& report)
{
  if (consolidation.representatives == 0)
    return;
  const double voxel = consolidation.voxel_size;
  report.representatives += consolidation.representatives;
  report.max_voxel_size = std::max(report.max_voxel_size, voxel);
  report.min_voxel_size =
      report.min_voxel_size > 0 ? std::min(report.min_voxel_size, voxel) : voxel;
}

/** \throws InputFileException if the voxels of a file are larger than any scene */
float
weightOf(const std::string& path, double voxel_size)
{
  constexpr double max_voxel = 1e9; // metres
  if (voxel_size <= max_voxel) {
    const double edges = voxel_size / min_voxel;
    return static_cast<float>(edges * edges);
  }
  std::ostringstream text;
  text.precision(3);
  text << path << ": its points are " << voxel_size
       << " m apart: these cannot be metres";
  throw InputFileException(text.str());
}

/** Poses that were rectified before differ from all VIEWPOINTs: one line is
 * sufficient. */
std::string
inOneLine(const std::vector<std::string>& remarks)
{
  const std::size_t others = remarks.size() - 1;
  return remarks.front() +
         (others > 0 ? "; and " + std::to_string(others) + " further files likewise"
                     : "");
}

} // namespace

/** Adds the consolidated points of an observation. */
void
SequenceConsolidation::consolidate(const std::string& path,
                                   const PointCloudFile& seen,
                                   const PointCloud<PointNormal>::Ptr& points,
                                   ConsolidatedObservations& found,
                                   SequenceConsolidationReport& report) const
{
  const double voxel_size = std::max(
      min_voxel,
      acmap::automaticVoxel(acmap::measureNoiseScale(
          seen.points(), acmap::SensorView(Eigen::Vector3f::Zero()), threads_)));
  const float weight = weightOf(path, voxel_size);
  VoxelConsolidation<PointNormal> consolidation;
  consolidation.setInputCloud(points);
  consolidation.setNumberOfThreads(threads_);
  consolidation.setVoxelSize(voxel_size);
  const PointCloud<PointNormal>::Ptr cloud(new PointCloud<PointNormal>);
  consolidation.filter(*cloud);
  found.weights.emplace_back(cloud->size(), weight);
  found.clouds.push_back(cloud);
  count(consolidation.getReport(), report);
}

void
SequenceConsolidation::compute(const ObservationSequence& sequence,
                               ConsolidatedObservations& result)
{
  const acmap::Progress progress(progress_);
  SequenceConsolidationReport report;
  ConsolidatedObservations found;
  std::vector<std::string> remarks;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    progress.tell(static_cast<double>(i) / static_cast<double>(sequence.size()),
                  "reading");
    try {
      const PosedObservation seen = sequence.load(i);
      remarks.insert(remarks.end(), seen.remarks.begin(), seen.remarks.end());
      const PointCloud<PointNormal>::Ptr points = finitePoints(seen.file->points());
      if (points->empty())
        report.remarks.push_back(sequence.path(i) + ": has no point");
      if (raw_points_) {
        found.weights.emplace_back();
        found.clouds.push_back(points);
      }
      else
        consolidate(sequence.path(i), *seen.file, points, found, report);
      found.places.push_back(i);
      found.trajectory.stamps.push_back(sequence.stamp(i));
      found.trajectory.poses.push_back(seen.T_map_camera);
      report.points += points->size();
      report.colored = report.colored || acmap::findColor(seen.file->cloud);
    }
    catch (const InputFileException& error) {
      if (!skip_broken_)
        throw;
      report.remarks.push_back("left out: " + std::string(error.what()));
    }
  }
  if (!remarks.empty())
    report.remarks.push_back(inOneLine(remarks));
  for (const std::string& remark : sequence.remarks())
    report.remarks.push_back(remark);
  if (found.places.empty())
    throw InputFileException("none of the observations can be read");
  sequence.requireDifferent(found.trajectory.poses);
  result = std::move(found);
  report_ = std::move(report);
}

MapLevellingReport
levelObservations(const MapLevelling<PointNormal>& levelling,
                  ConsolidatedObservations& observations,
                  unsigned int threads)
{
  MapLevelling<PointNormal> level = levelling;
  level.clear();
  level.setNumberOfThreads(threads);
  std::vector<Eigen::Isometry3d>& poses = observations.trajectory.poses;
  for (std::size_t i = 0; i < poses.size(); ++i)
    level.addPointCloud(observations.clouds[i], poses[i], observations.weights[i]);
  level.compute();
  for (std::size_t i = 0; i < poses.size(); ++i)
    poses[i] = level.getPose(i);
  return level.getReport();
}

} // namespace pcl
