#pragma once

#include <pcl/core/impl/input_check.h>
#include <pcl/mapping/impl/posed_clouds.h>
#include <pcl/mapping/impl/rectification_kernel.h>

#include <oneapi/tbb/parallel_for.h>

#include <vector>

namespace pcl::acmap {

/** \brief Observations in levelled frames, whose poses are planar. */
struct LevelledClouds {
  std::vector<LevelledPoints> observations;
  std::vector<Eigen::Isometry3d> given; ///< in a map whose y axis points down
  std::vector<PlanarPose> poses;        ///< their planar parts
};

/** \brief Levels observations.
 * \param[in] loaders, weights, poses of the observations
 * \param[in] upright from the map to one whose y axis points down */
template <typename Loader>
LevelledClouds
levelledClouds(const std::vector<Loader>& loaders,
               const std::vector<std::vector<float>>& weights,
               const std::vector<Eigen::Isometry3d>& poses,
               const Eigen::Quaterniond& upright)
{
  LevelledClouds level;
  level.observations.resize(loaders.size());
  for (const Eigen::Isometry3d& pose : poses) {
    level.given.push_back(upright * pose);
    level.poses.push_back(planarPartOf(level.given.back()));
  }
  oneapi::tbb::parallel_for(std::size_t{0}, loaders.size(), [&](std::size_t i) {
    const auto cloud = loaders[i]();
    level.observations[i] =
        levelledPoints(pointsOf(*cloud), normalsOf(*cloud), level.given[i], weights[i]);
  });
  return level;
}

} // namespace pcl::acmap
