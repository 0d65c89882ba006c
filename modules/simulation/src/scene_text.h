#pragma once

#include <pcl/core/yaml_node.h>
#include <pcl/simulation/simulated_scene.h>

namespace pcl::acmap {

/** \brief Makes the scene that a document describes. */
SimulatedScene
readScene(const YamlNode& document);

} // namespace pcl::acmap
