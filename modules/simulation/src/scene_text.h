#pragma once

#include <pcl/core/yaml_node.h>
#include <pcl/simulation/simulated_scene.h>

namespace pcl::acmap {

/** \brief Creates the scene that is described by a document. */
SimulatedScene
readScene(const YamlNode& document);

} // namespace pcl::acmap
