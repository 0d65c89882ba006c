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

/** \brief Observations in temporal order, with their true poses. */
struct EgomotionSequence {
  std::string name;
  bool is_planar = false; ///< the camera keeps its height and does not tilt
  TrinocularRig camera;   ///< pinhole model of the clouds' pixels
  std::vector<EgomotionCloud::ConstPtr> clouds;
  std::vector<Eigen::Isometry3d> truth; ///< T_map_camera
};

/** \brief Simulates a drive through a standard scene with stereo matching of ten
 * patterns, and one shot without.
 * \param[in] grain of all walls, floors and ceilings, grey levels; none: the grain of
 * the scene (2)
 * \param[in] views maximum number of views */
EgomotionSequence
driveThrough(const std::string& scene,
             std::optional<double> grain = {},
             std::size_t views = 1000);

/** \brief Every tenth frame of a hand-held Kinect sequence (7-Scenes, RedKitchen), in
 * the frame of its colour camera; nothing, with a message, if the data are missing. */
std::optional<EgomotionSequence>
loadKitchen();

} // namespace pcl::acmap::bench
