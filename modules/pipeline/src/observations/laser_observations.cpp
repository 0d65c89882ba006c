#include "poses/level_frame.h"

#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/core/carmen_log.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/output_file.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/pipeline/laser_observations.h>
#include <pcl/pipeline/map_rows.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <locale>
#include <sstream>
#include <utility>

namespace pcl {

namespace {

void
requirePoseOfEach(const LaserObservations& observations,
                  const std::vector<Eigen::Isometry3d>& poses)
{
  if (poses.size() != observations.clouds.size())
    throw acmap::BadArgument("there are ",
                             poses.size(),
                             " poses for ",
                             observations.clouds.size(),
                             " scans");
}

/** Some logs have the same stamp for all scans. */
bool
doGrow(const std::vector<double>& stamps)
{
  return std::adjacent_find(stamps.begin(), stamps.end(), std::greater_equal<>()) ==
         stamps.end();
}

} // namespace

LaserObservations
observationsOf(std::vector<PlanarScan> scans, std::size_t every)
{
  LaserObservations observations;
  std::vector<double>& stamps = observations.trajectory.stamps;
  every = std::max<std::size_t>(every, 1);
  std::size_t beams = 0;
  for (std::size_t i = 0; i < scans.size(); i += std::min(every, scans.size() - i)) {
    const PlanarScan& scan = scans[i];
    PlanarScanPoints echoes = pointsOf(scan);
    beams += scan.ranges.size();
    observations.points += echoes.cloud->size();
    stamps.push_back(scan.stamp);
    observations.trajectory.poses.push_back(isometryOf(scan.pose));
    observations.clouds.push_back(std::move(echoes.cloud));
    observations.weights.push_back(std::move(echoes.weights));
    observations.scans.push_back(std::move(scans[i]));
  }
  if (!doGrow(stamps)) {
    for (std::size_t i = 0; i < stamps.size(); ++i)
      stamps[i] = static_cast<double>(i * every);
    observations.remarks.emplace_back(
        "the stamps of the log do not grow; the trajectory has the numbers of the "
        "scans instead");
  }
  observations.missing_beams = beams - observations.points;
  return observations;
}

RectifiedLaser
rectifyLaser(LaserObservations& observations,
             const MapLevelling<PointNormal>& levelling,
             EntropyRectification<PointNormal> rectification)
{
  RectifiedLaser found;
  found.levelling =
      levelObservations(levelling, observations, rectification.getNumberOfThreads());
  found.poses = acmap::rectifiedPoses(
      acmap::LevelFrame(), observations, found.levelling.axis, rectification);
  found.report = rectification.getReport();
  return found;
}

CloudRows
echoesOf(const LaserObservations& observations,
         const std::vector<Eigen::Isometry3d>& poses,
         const CostCallback& cost)
{
  requirePoseOfEach(observations, poses);
  acmap::MapRows map(observations.points, false, cost);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    PointCloud<PointXYZ> echoes;
    copyPointCloud(*observations.clouds[i], echoes);
    PointCloudFile file;
    toPCLPointCloud2(echoes, file.cloud);
    map.append(file, poses[i], static_cast<std::int32_t>(i));
  }
  return map.finish();
}

void
saveCorrectedLog(const std::string& path,
                 const LaserObservations& observations,
                 const std::vector<Eigen::Isometry3d>& poses)
{
  requirePoseOfEach(observations, poses);
  std::vector<PlanarScan> scans = observations.scans;
  std::vector<PlanarPose> before;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    before.push_back(scans[i].pose);
    scans[i].pose = planarPartOf(poses[i]);
  }
  saveCarmenLog(path, scans, before);
}

void
savePlanarPoses(const std::string& path,
                const LaserObservations& observations,
                const std::vector<Eigen::Isometry3d>& poses)
{
  requirePoseOfEach(observations, poses);
  std::ostringstream table;
  table.imbue(std::locale::classic());
  table.precision(std::numeric_limits<double>::max_digits10);
  table << "# stamp x y theta: seconds, metres, radians; x forward, y left, theta "
           "counter-clockwise\n";
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const PlanarPose pose = planarPartOf(poses[i]);
    table << observations.scans[i].stamp << ' ' << pose.z << ' ' << 0.0 - pose.x << ' '
          << 0.0 - pose.theta << '\n';
  }
  const std::string text = table.str();
  acmap::OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

} // namespace pcl
