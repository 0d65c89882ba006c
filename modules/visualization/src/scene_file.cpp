#include <pcl/visualization/scene_file.h>

#include "vtk_mesh_reader.h"

#include <pcl/core/mesh_file.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace pcl {

SceneFile
loadScene(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  if (ending == ".vtk")
    return acmap::readVtkMesh(path);
  SceneFile scene;
  scene.points = loadPointCloud(path);
  if (ending == ".ply" || ending == ".obj")
    scene.mesh = loadTriangleMesh(path);
  return scene;
}

} // namespace pcl
