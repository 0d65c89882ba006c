#pragma once

#include "clouds/e57_scans.h"
#include "clouds/point_cloud_readers.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief The shift for the points of a scan, of some of its first ones.
 * \param[in] T_frame_scan of the frame in which they are wanted */
Eigen::Vector3d
shiftOf(const E57Scan& scan,
        const Eigen::Isometry3d& T_frame_scan,
        const CloudStatement& stated,
        ScanReader& reader);

/** \brief Reads scans into one cloud. Its coordinates are checked last, because empty cells
 * of a grid are not finite.
 * \param[in] T_frame_scan for each scan that of the frame of the cloud
 * \param[in] shift to be subtracted from coordinates
 * \param[out] rows see \ref readE57
 * \param[out] check of all points */
void
readScans(const std::vector<E57Scan>& scans,
          const std::vector<Eigen::Isometry3d>& T_frame_scan,
          const Eigen::Vector3d& shift,
          ScanReader& reader,
          LargeVector<std::uint8_t>* rows,
          PCLPointCloud2& cloud,
          CoordinateCheck& check);

} // namespace pcl::acmap
