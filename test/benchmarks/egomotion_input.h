#pragma once

#include <pcl/core/point_types.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/point_cloud.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

using EgomotionCloud = PointCloud<PointXYZRGBSigma>;

/** \brief Observations in the order in which they were taken, with their true poses. */
struct EgomotionSequence {
  std::string name;
  bool is_planar = false; ///< the camera keeps its height and does not tilt
  TrinocularRig camera;   ///< pinhole of the clouds' pixels
  std::vector<EgomotionCloud::ConstPtr> clouds;
  std::vector<Eigen::Isometry3d> truth; ///< T_map_camera
};

/** \brief Drives through a standard scene and sees it by stereo: ten patterns and a shot
 * without, simulated and matched.
 * \param[in] grain of all walls, floors and ceilings, grey levels; none: as the scene has
 * it (2)
 * \param[in] views that are taken at most */
EgomotionSequence
driveThrough(const std::string& scene,
             std::optional<double> grain = {},
             std::size_t views = 1000);

/** \brief Every tenth frame of a hand-held Kinect's sequence (7-Scenes, RedKitchen), in
 * the frame of its colour camera; nothing, with a word, where the data are not there. */
std::optional<EgomotionSequence>
loadKitchen();

} // namespace pcl::acmap::bench
