#pragma once

#include <pcl/core/planar_pose.h>
#include <pcl/mapping/map_entropy_kernel.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Observations with normals and true poses, for the entropy of their map. */
struct EntropyMap {
  std::string name;
  std::vector<std::vector<Eigen::Vector3f>> points;  ///< metres, sensors' frames
  std::vector<std::vector<Eigen::Vector3f>> normals; ///< unit
  std::vector<std::vector<float>> weights;           ///< empty: 1 each
  std::vector<PlanarPose> poses;

  std::size_t
  size() const;

  std::vector<PosedPoints>
  observations() const;
};

/** \brief All views of the simulated corridor, normals those of its planes. */
EntropyMap
makePaperMap();

/** \brief 200 laser scans of 180 beams in a building of 30 x 30 m with 25 rooms; a point
 * weighs as much wall as its beam stands for. */
EntropyMap
makeLaserMap();

} // namespace pcl::acmap::bench
