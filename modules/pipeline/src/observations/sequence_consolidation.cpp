#include <pcl/core/exceptions.h>
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
count(const ConsolidatedObservation& observation, SequenceConsolidationReport& report)
{
  report.points += observation.points;
  report.colored = report.colored || observation.is_colored;
  const double voxel = observation.voxel_size;
  if (voxel == 0 || observation.cloud->empty())
    return;
  report.representatives += observation.cloud->size();
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

} // namespace

ConsolidatedObservation
SequenceConsolidation::consolidate(const PointCloudFile& observation,
                                   const std::string& name) const
{
  ConsolidatedObservation found;
  const PointCloud<PointNormal>::Ptr points = finitePoints(observation.points());
  found.points = points->size();
  found.is_colored = acmap::findColor(observation.cloud) != nullptr;
  found.cloud = points;
  if (raw_points_)
    return found;
  found.voxel_size = std::max(
      min_voxel,
      acmap::automaticVoxel(acmap::measureNoiseScale(
          observation.points(), acmap::SensorView(Eigen::Vector3f::Zero()), threads_)));
  found.weight = weightOf(name, found.voxel_size);
  VoxelConsolidation<PointNormal> consolidation;
  consolidation.setInputCloud(points);
  consolidation.setNumberOfThreads(threads_);
  consolidation.setVoxelSize(found.voxel_size);
  found.cloud.reset(new PointCloud<PointNormal>);
  consolidation.filter(*found.cloud);
  return found;
}

void
SequenceConsolidation::compute(const ObservationSequence& sequence,
                               ConsolidatedObservations& result)
{
  const acmap::Progress progress(progress_);
  SequenceConsolidationReport report;
  ConsolidatedObservations found;
  std::vector<std::string> remarks;
  if (!consolidated_.empty() && consolidated_.size() != sequence.size())
    throw acmap::BadArgument(std::to_string(consolidated_.size()) +
                             " consolidated observations for a sequence of " +
                             std::to_string(sequence.size()));
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    progress.tell(static_cast<double>(i) / static_cast<double>(sequence.size()),
                  "reading");
    try {
      ConsolidatedObservation one;
      Eigen::Isometry3d T_map_camera;
      if (consolidated_.empty()) {
        const PosedObservation seen = sequence.load(i);
        remarks.insert(remarks.end(), seen.remarks.begin(), seen.remarks.end());
        one = consolidate(*seen.file, sequence.path(i));
        T_map_camera = seen.T_map_camera;
      }
      else {
        one = consolidated_[i];
        T_map_camera = sequence.pose(i);
      }
      if (one.points == 0)
        report.remarks.push_back(sequence.path(i) + ": has no point");
      count(one, report);
      found.clouds.push_back(one.cloud);
      found.weights.emplace_back(raw_points_ ? 0 : one.cloud->size(), one.weight);
      found.places.push_back(i);
      found.trajectory.stamps.push_back(sequence.stamp(i));
      found.trajectory.poses.push_back(T_map_camera);
    }
    catch (const InputFileException& error) {
      if (!skip_broken_)
        throw;
      report.remarks.push_back("left out: " + std::string(error.what()));
    }
  }
  if (!remarks.empty())
    report.remarks.push_back(acmap::inOneLine(remarks));
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
