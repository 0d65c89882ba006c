#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/simulation/simulated_scene.h>

#include <string>

namespace pcl {

/** \brief Reads a scene: surfaces, rig, sensor and path, as YAML; the format is
 * described in doc/simulation/scene_file.md.
 * \throws InputFileException naming file, line, column and fault: invalid YAML, a
 * missing, unknown or repeated key, a value out of range, a surface without area, a
 * rectangle outside its plane, a building that is not a standard scene, no view.
 * \ingroup simulation */
ACMAP_EXPORT SimulatedScene
loadSimulatedScene(const std::string& path);

} // namespace pcl
