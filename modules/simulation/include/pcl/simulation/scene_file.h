#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/simulation/simulated_scene.h>

#include <string>

namespace pcl {

/** \brief Reads a scene: surfaces, rig, sensor and path, as YAML; the format stands in
 * doc/simulation/scene_file.md.
 * \throws InputFileException naming file, line, column and fault: no YAML, a key that is
 * missing, unknown or there twice, a value out of its range, a surface without area, a
 * rectangle outside its plane, a building that no standard scene has, no view. \ingroup simulation */
ACMAP_EXPORT SimulatedScene
loadSimulatedScene(const std::string& path);

} // namespace pcl
