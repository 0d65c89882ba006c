#include "rectification_outputs.h"

#include "cloud_fields.h"
#include "energy_picture.h"
#include "map_rows.h"
#include "observation_folder.h"
#include "plan_picture.h"

#include <pcl/core/point_cloud_writer.h>

namespace pcl::acmap {

namespace {

/** Of all poses and points, before and after. */
PlanExtent
extentOf(const MapObservations& observations,
         const std::vector<Eigen::Isometry3d>& poses)
{
  PlanContents contents;
  for (const auto* all : {&observations.trajectory.poses, &poses})
    for (std::size_t i = 0; i < all->size(); ++i) {
      const Eigen::Isometry3d& T_map_camera = (*all)[i];
      contents.addPlace(T_map_camera.translation());
      for (const PointNormal& point : *observations.clouds[i])
        contents.addPoint(T_map_camera * point.getVector3fMap().cast<double>());
    }
  return contents.extent();
}

void
addTo(PlanPicture& plan,
      const PointCloudFile& observation,
      const Eigen::Isometry3d& T_map_camera)
{
  const PointView points = observation.points();
  for (std::size_t i = 0; i < points.size(); ++i)
    plan.add(T_map_camera * points[i].cast<double>());
}

void
drawPlans(const MapObservations& observations,
          const std::vector<Eigen::Isometry3d>& poses,
          const PlanPicture& before,
          const PlanPicture& after,
          const OutputFolder& folder)
{
  const RgbImage image_before = before.draw(observations.trajectory.poses, red);
  const RgbImage image_after = after.draw(poses, blue);
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
             const std::vector<RectificationStep>& steps,
             const OutputFolder& folder)
{
  MapRows map(options.write_map ? observations.points : 0, observations.colored);
  const PlanExtent extent = extentOf(observations, poses);
  PlanPicture before(extent), after(extent);
  tool.withProgress([&](const ProgressCallback& callback) {
    const Progress progress(callback);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      progress.tell(static_cast<double>(i) / static_cast<double>(poses.size()),
                    "writing");
      PointCloudFile observation = observations.load(i);
      if (options.write_map)
        map.append(observation, poses[i], static_cast<std::int32_t>(i));
      addTo(before, observation, observations.trajectory.poses[i]);
      addTo(after, observation, poses[i]);
      if (options.write_observations) {
        dropUnwritableFields(observation.cloud);
        saveObservation(folder.path(observationName(i)), observation.cloud, poses[i]);
      }
    }
  });
  if (options.write_map)
    savePointCloud(folder.path("map.pcd"), map.finish());
  saveTrajectory(folder.path(trajectory_name), {observations.trajectory.stamps, poses});
  saveTrajectory(folder.path("trajectory_before.txt"), observations.trajectory);
  drawPlans(observations, poses, before, after, folder);
  savePng(folder.path("energy.png"), energyPicture(steps));
}

} // namespace pcl::acmap
