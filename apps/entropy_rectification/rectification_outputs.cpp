#include "rectification_outputs.h"

#include "energy_curve.h"
#include "memory.h"
#include "plan_picture.h"

#include <pcl/core/cloud_fields.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/pipeline/map_rows.h>
#include <pcl/pipeline/observation_files.h>

namespace pcl::acmap {

namespace {

using Poses = std::vector<Eigen::Isometry3d>;

/** Transforms the poses to a frame whose xz plane is the floor. */
Poses
alongFloor(const Eigen::Vector3d& floor, Poses poses)
{
  const Eigen::Isometry3d turn(
      Eigen::Quaterniond::FromTwoVectors(floor, Eigen::Vector3d::UnitY()));
  for (Eigen::Isometry3d& pose : poses)
    pose = turn * pose;
  return poses;
}

/** Extent of all poses and points, before and after. */
PlanExtent
extentOf(const MapObservations& observations, const Poses& before, const Poses& after)
{
  PlanContents contents;
  for (const Poses* all : {&before, &after})
    for (std::size_t i = 0; i < all->size(); ++i) {
      const Eigen::Isometry3d& T_plan_camera = (*all)[i];
      contents.addPlace(T_plan_camera.translation());
      for (const PointNormal& point : *observations.clouds[i])
        contents.addPoint(T_plan_camera * point.getVector3fMap().cast<double>());
    }
  return contents.extent();
}

void
addTo(PlanPicture& plan,
      const PointCloudFile& observation,
      const Eigen::Isometry3d& T_plan_camera)
{
  const PointView points = observation.points();
  for (std::size_t i = 0; i < points.size(); ++i)
    plan.add(T_plan_camera * points[i].cast<double>());
}

void
drawPlans(const Poses& poses_before,
          const Poses& poses_after,
          const PlanPicture& before,
          const PlanPicture& after,
          const OutputFolder& folder)
{
  const RgbImage image_before = before.draw(poses_before, red);
  const RgbImage image_after = after.draw(poses_after, blue);
  savePng(folder.path("plan_before.png"), image_before);
  savePng(folder.path("plan_after.png"), image_after);
  savePng(folder.path("plan.png"), beside(image_before, image_after));
}

} // namespace

void
writeOutputs(Tool& tool,
             const RectificationOptions& options,
             const MapObservations& observations,
             const std::vector<Eigen::Isometry3d>& poses,
             const Eigen::Vector3d& floor,
             const std::vector<RectificationStep>& steps,
             const OutputFolder& folder)
{
  MapRows map(options.write_map ? observations.points : 0,
              observations.colored,
              [](const std::string& work, std::size_t bytes, double) {
                requireMemory(bytes, work);
              });
  const Poses plan_before = alongFloor(floor, observations.trajectory.poses);
  const Poses plan_after = alongFloor(floor, poses);
  const PlanExtent extent = extentOf(observations, plan_before, plan_after);
  PlanPicture before(extent), after(extent);
  tool.withProgress([&](const ProgressCallback& callback) {
    const Progress progress(callback);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      progress.tell(static_cast<double>(i) / static_cast<double>(poses.size()),
                    "writing");
      const std::shared_ptr<const PointCloudFile> observation = observations.load(i);
      if (options.write_map)
        map.append(*observation, poses[i], static_cast<std::int32_t>(i));
      addTo(before, *observation, plan_before[i]);
      addTo(after, *observation, plan_after[i]);
      if (options.write_observations) {
        PCLPointCloud2 cloud = observation->cloud;
        dropUnwritableFields(cloud);
        saveObservation(folder.path(observationName(i)), cloud, poses[i]);
      }
    }
  });
  if (options.write_map)
    savePointCloud(folder.path("map.pcd"), map.finish());
  saveTrajectory(folder.path(trajectory_name), {observations.trajectory.stamps, poses});
  saveTrajectory(folder.path("trajectory_before.txt"), observations.trajectory);
  drawPlans(plan_before, plan_after, before, after, folder);
  savePng(folder.path("energy.png"), energyPicture(steps));
}

} // namespace pcl::acmap
