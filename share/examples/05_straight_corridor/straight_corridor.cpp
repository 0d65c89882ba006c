// Two ways to estimate the trajectory of a robot in a corridor: from the images of its
// camera, and from bad odometry that is rectified until the map is consistent.
// Usage: straight_corridor [VIEWS]   8 to 51, default 24

#include <pcl/conversions.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/point_types.h>
#include <pcl/core/trajectory_error.h>
#include <pcl/egomotion/visual_egomotion.h>
#include <pcl/filters/voxel_consolidation.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using View = pcl::PointCloud<pcl::PointXYZRGBSigma>;
using Poses = std::vector<Eigen::Isometry3d>; // T_map_camera

// Observations of a robot that drives along a corridor, 40 cm from view to view:
// organized clouds in the frame of the camera, with colour and sigma.
std::vector<View::Ptr>
drive(const pcl::SimulatedScene& scene, std::size_t number)
{
  std::vector<View::Ptr> views;
  for (std::size_t i = 0; i < number; ++i) {
    views.emplace_back(new View);
    pcl::fromPCLPointCloud2(pcl::cloudOf(pcl::observe(scene, i, 1)), *views.back());
  }
  return views;
}

// Chains the motions between consecutive views; throws if one of them is unknown.
Poses
posesBySight(const std::vector<View::Ptr>& views)
{
  pcl::VisualEgomotion<pcl::PointXYZRGBSigma> egomotion;
  pcl::PlanarPose pose;
  Poses poses = {pcl::isometryOf(pose)};
  for (std::size_t i = 1; i < views.size(); ++i) {
    egomotion.setInputTarget(views[i - 1]);
    egomotion.setInputSource(views[i]);
    const auto estimate = egomotion.compute();
    if (!estimate)
      throw std::runtime_error("view " + std::to_string(i) + ": " +
                               egomotion.getReport().reason);
    pose = pcl::moved(pose, estimate->action);
    poses.push_back(pcl::isometryOf(pose));
  }
  return poses;
}

// Simulates wheels of different size: each motion turns 0.5 degrees too far.
Poses
posesByWheels(const Poses& truth)
{
  pcl::PlanarPose pose;
  Poses poses = {pcl::isometryOf(pose)};
  for (std::size_t i = 1; i < truth.size(); ++i) {
    pcl::PlanarAction action = pcl::actionBetween(pcl::planarPartOf(truth[i - 1]),
                                                  pcl::planarPartOf(truth[i]));
    action.dtheta += 0.5 * M_PI / 180;
    pose = pcl::moved(pose, action);
    poses.push_back(pcl::isometryOf(pose));
  }
  return poses;
}

Poses
rectified(const std::vector<View::Ptr>& views, const Poses& poses)
{
  pcl::EntropyRectification<pcl::PointNormal> rectification;
  pcl::VoxelConsolidation<pcl::PointNormal> consolidation; // computes normals
  for (std::size_t i = 0; i < views.size(); ++i) {
    const pcl::PointCloud<pcl::PointNormal>::Ptr cloud(
        new pcl::PointCloud<pcl::PointNormal>);
    pcl::copyPointCloud(*views[i], *cloud);
    consolidation.setInputCloud(cloud);
    consolidation.filter(*cloud);
    rectification.addPointCloud(cloud, poses[i]);
  }
  rectification.compute();
  const pcl::EntropyRectificationReport& report = rectification.getReport();
  std::cout << "rectification: " << report.reason << "\n";
  Poses found;
  for (std::size_t i = 0; i < views.size(); ++i)
    found.push_back(rectification.getPose(i));
  return found;
}

double
tell(const char* how, const Poses& found, const Poses& truth)
{
  const double error = pcl::absoluteTrajectoryError(found, truth).aligned;
  std::cout << how << ": " << 1000 * error << " mm off the true way\n";
  return error;
}

} // namespace

int
main(int argc, char** argv)
{
  const int number = argc == 2 ? std::atoi(argv[1]) : 24;
  if (argc > 2 || number < 8 || number > 51) {
    std::cerr << "usage: straight_corridor [VIEWS]   8 to 51, default 24\n";
    return 2;
  }
  try {
    const pcl::SimulatedScene scene = pcl::standardScene("corridor_drive");
    const Poses truth = pcl::trajectoryOf(scene, number).poses;
    const std::vector<View::Ptr> views = drive(scene, number);
    const double seen = tell("by sight", posesBySight(views), truth);
    const Poses wheels = posesByWheels(truth);
    const double bent = tell("by wheels", wheels, truth);
    const double straight =
        tell("by wheels, rectified", rectified(views, wheels), truth);
    if (seen > 0.05 || straight > 0.5 * bent) {
      std::cerr << "straight_corridor: the corridor is not straight\n";
      return 1;
    }
  }
  catch (const std::exception& e) {
    std::cerr << "straight_corridor" << e.what() << "\n";
    return 1;
  }
}
