#pragma once

#include <pcl/core/planar_pose.h>
#include <pcl/mapping/impl/map_entropy_kernel.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Observations with normals and true poses, to compute the entropy of their
 * map. */
struct EntropyMap {
  std::string name;
  std::vector<std::vector<Eigen::Vector3f>> points;  ///< metres, sensor frames
  std::vector<std::vector<Eigen::Vector3f>> normals; ///< unit
  std::vector<std::vector<float>> weights;           ///< empty: all 1
  std::vector<PlanarPose> poses;

  std::size_t
  size() const;

  std::vector<PosedPoints>
  observations() const;
};

/** \brief All views of the simulated corridor, with the normals of its planes. */
EntropyMap
makePaperMap();

/** \brief 200 laser scans of 180 beams in a building of 30 x 30 m with 25 rooms; the
 * weight of a point is the length of wall that its beam represents. */
EntropyMap
makeLaserMap();

} // namespace pcl::acmap::bench
