#pragma once

#include "clouds/e57_scans.h"
#include "clouds/point_cloud_readers.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief The shift for the points of a scan: that of its first one that is finite.
 * \param[in] T_frame_scan of the frame in which they are wanted */
Eigen::Vector3d
shiftOf(const E57Scan& scan, const Eigen::Isometry3d& T_frame_scan, E57Pages& pages);

/** \brief Reads scans into one cloud. Its coordinates are checked last, because empty cells
 * of a grid are not finite.
 * \param[in] T_frame_scan for each scan that of the frame of the cloud
 * \param[in] shift to be subtracted from coordinates; none: that of the first point that is
 * finite
 * \param[out] rows see \ref readE57
 * \param[out] check of all points
 * \return what was subtracted from coordinates */
Eigen::Vector3d
readScans(const std::vector<E57Scan>& scans,
          const std::vector<Eigen::Isometry3d>& T_frame_scan,
          const std::optional<Eigen::Vector3d>& shift,
          E57Pages& pages,
          LargeVector<std::uint8_t>* rows,
          PCLPointCloud2& cloud,
          CoordinateCheck& check);

} // namespace pcl::acmap
