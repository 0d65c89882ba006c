#pragma once

#include <pcl/core/yaml_node.h>
#include <pcl/simulation/scene_geometry.h>

namespace pcl::acmap {

/** \brief Reads `looks` and `surfaces` of a scene. */
SceneGeometry
readSurfaces(const YamlNode& scene);

} // namespace pcl::acmap
