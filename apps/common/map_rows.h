#pragma once

#include <pcl/core/point_cloud_file.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace pcl::acmap {

/** \brief The cloud of a whole map, observation by observation: `x y z`, `rgb` where
 * somebody has colours, and `view`, the number of the observation. */
class MapRows {
public:
  /** \param[in] points it is sure to hold, 0 when not known
   * \throws MemoryRefused when this machine has too little for them */
  MapRows(std::size_t points, bool colored);

  /** \brief From more points than that on, each second one is dropped, again and again. */
  void
  setMost(std::size_t points)
  {
    most_ = points;
  }

  /** \brief Which of the finite points are kept: each of this number. */
  std::size_t
  every() const
  {
    return every_;
  }

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
  std::size_t most_ = std::numeric_limits<std::size_t>::max();
  std::size_t every_ = 1;
  std::size_t seen_ = 0; ///< finite points
};

/** \brief The first row and each n-th after it. */
PCLPointCloud2
everyNth(const PCLPointCloud2& cloud, std::size_t n);

} // namespace pcl::acmap
