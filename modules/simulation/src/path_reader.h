#pragma once

#include <pcl/core/yaml_node.h>

#include <Eigen/Geometry>

#include <vector>

namespace pcl::acmap {

/** \brief Reads the `path` of a scene: T_scene_camera of each view. */
std::vector<Eigen::Isometry3d>
readPath(const YamlNode& path);

} // namespace pcl::acmap
