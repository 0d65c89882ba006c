#pragma once

#include <pcl/visualization/scene_file.h>

#include <string>

namespace pcl::acmap {

/** \brief Reads a legacy VTK file of polygons.
 * \throws InputFileException */
SceneFile
readVtkMesh(const std::string& path);

} // namespace pcl::acmap
