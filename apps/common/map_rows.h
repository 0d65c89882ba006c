#pragma once

#include <pcl/core/point_cloud_file.h>

#include <Eigen/Geometry>

#include <cstddef>

namespace pcl::acmap {

/** \brief The cloud of a whole map, observation by observation: `x y z`, `rgb` where
 * somebody has colours, and `view`, the number of the observation. */
class MapRows {
public:
  /** \param[in] points it is sure to hold, 0 when not known
   * \throws MemoryRefused when this machine has too little for them */
  MapRows(std::size_t points, bool colored);

  /** \brief Appends the finite points of an observation, black without colours.
   * \throws MemoryRefused when this machine has too little for them */
  void
  append(const PointCloudFile& observation,
         const Eigen::Isometry3d& T_map_camera,
         std::int32_t view);

  /** \brief The cloud of what was appended. Nothing can be appended afterwards. */
  PCLPointCloud2
  finish();

private:
  PCLPointCloud2 cloud_;
  bool colored_;
  std::size_t promised_; ///< bytes that there is memory for
};

} // namespace pcl::acmap
