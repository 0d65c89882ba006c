#include "rectification_run.h"

#include "level_check.h"
#include "map_observations.h"
#include "output_target.h"
#include "rectification_outputs.h"
#include "rectification_reports.h"

#include <pcl/mapping/entropy_rectification.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

using Rectification = pcl::EntropyRectification<pcl::PointNormal>;

void
rectify(Tool& tool,
        const RectificationOptions& options,
        const MapObservations& observations,
        Rectification& rectification)
{
  rectification.setMode(options.mode);
  rectification.setBinSize(options.binSize());
  rectification.setSeed(options.seed);
  rectification.setOdometryNoise(options.odometry);
  rectification.setNumberOfThreads(tool.threads());
  for (std::size_t i = 0; i < observations.clouds.size(); ++i)
    rectification.addPointCloud(observations.clouds[i],
                                observations.trajectory.poses[i],
                                observations.weights[i]);
  tool.withProgress([&](const pcl::ProgressCallback& progress) {
    rectification.setProgressCallback(progress);
    rectification.compute();
  });
}

std::vector<Eigen::Isometry3d>
posesOf(const Rectification& rectification)
{
  std::vector<Eigen::Isometry3d> poses;
  for (std::size_t i = 0; i < rectification.getNumberOfPointClouds(); ++i)
    poses.push_back(rectification.getPose(i));
  return poses;
}

/** \brief Do all poses have the same height, and rotate about y only, as for motions on
 * a floor? */
bool
areOnAFloor(const std::vector<Eigen::Isometry3d>& poses)
{
  constexpr double level = 1 - 1e-8, height = 1e-4; // cosine, metres
  return poses.size() > 1 &&
         std::all_of(poses.begin(), poses.end(), [&](const Eigen::Isometry3d& pose) {
           const double rise = pose.translation().y() - poses[0].translation().y();
           return pose.linear()(1, 1) > level && std::abs(rise) < height;
         });
}

/** \brief Warns of a map that is not level.
 * \return the normal of its floor; y of a level map */
Eigen::Vector3d
checkLevel(Tool& tool, const MapObservations& observations)
{
  constexpr double most = 10; // degrees
  constexpr double degrees = 180 / 3.14159265358979323846;
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d floor = floorNormalOf(observations).value_or(y);
  const double tilt = degrees * std::acos(std::min(1.0, floor.y()));
  if (tilt <= most)
    return y;
  tool.warn(
      "floors and ceilings lie " + std::to_string(std::lround(tilt)) +
      " degrees off the xz plane: the map is not level, and is rectified about its "
      "y axis all the same; plans are drawn along the floor" +
      (areOnAFloor(observations.trajectory.poses)
           ? "; its poses turn about y only: where a hand held the camera, find "
             "them again with --6dof (of pcl_visual_egomotion or "
             "pcl_compact_mapping)"
           : ""));
  return floor;
}

} // namespace

void
rectifyPoses(Tool& tool,
             const RectificationOptions& options,
             const std::optional<ObservationSequence>& posed)
{
  StepTimer timer(tool.report());
  OutputFolder folder(options.output);
  if (folder.holds(options.input()) || folder.holds(options.input() + "/any"))
    throw UsageError(options.output + ": holds the input; name another folder");
  requireNoSequence(folder);
  tool.requireReportWritable({options.input()});
  const MapObservations observations =
      posed ? readObservations(tool, *posed, options.skip_broken)
            : readScans(tool, options.log, options.every);
  if (observations.points == 0)
    throw NothingFound(options.input() + ": has no point");
  const Eigen::Vector3d floor =
      posed ? checkLevel(tool, observations) : Eigen::Vector3d::UnitY();
  timer.finish("read");

  Rectification rectification;
  rectify(tool, options, observations, rectification);
  timer.finish("rectify");

  const EntropyRectificationReport& report = rectification.getReport();
  writeOutputs(
      tool, options, observations, posesOf(rectification), floor, report.steps, folder);
  tool.stopIfInterrupted();
  folder.commit();
  timer.finish("write");
  tellOutcome(tool, options, report);
  tool.details()["posed_files"] = observations.files;
  tool.tellSeconds();
  tool.tell("folder", options.output);
}

} // namespace pcl::acmap
