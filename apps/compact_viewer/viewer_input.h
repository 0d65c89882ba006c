#pragma once

#include <pcl/visualization/layered_scene.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief The data to be shown. */
struct ViewerInput {
  LayeredScene scene;
  Eigen::Vector3f sensor_origin = Eigen::Vector3f::Zero(); ///< metres
  Eigen::Quaternionf sensor_orientation = Eigen::Quaternionf::Identity();
  std::optional<Eigen::Vector3f> up; ///< if the file format defines one: y of OBJ
  std::vector<std::string> remarks;  ///< warnings
};

/** \brief Reads a cloud, a mesh, planes (.json), or a folder with map.json, or with
 * map.pcd and trajectory.txt, and the other files in the folder: mesh.ply, map.pcd,
 * trajectory.txt, trajectory_before.txt.
 * \param[in] scale metres in a unit of a cloud or mesh
 * \throws InputFileException naming file and fault
 * \throws UsageError for a scale of a map
 * \throws NothingFound when no point is finite and there is no plane */
ViewerInput
loadViewerInput(const std::string& path, double scale);

/** \brief Number of points of the cloud, or of the mesh if there is no cloud. */
std::size_t
pointsIn(const LayeredScene& scene);

} // namespace pcl::acmap
