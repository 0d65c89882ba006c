#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/point_view.h>

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pcl {

/** \brief A point cloud as it came from a file. \ingroup core */
struct PointCloudFile {
  /** \brief The points with all their scalar fields. Fields x, y, z are float32 and stand
   * together, whatever the file had; a colour of three bytes became PCL's packed `rgb`. */
  PCLPointCloud2 cloud;

  /** \brief Sensor pose (VIEWPOINT of a PCD; identity where the format has none). */
  Eigen::Vector3f sensor_origin = Eigen::Vector3f::Zero();
  Eigen::Quaternionf sensor_orientation = Eigen::Quaternionf::Identity();

  /** \brief Oddities that did not prevent reading, a line each. */
  std::vector<std::string> remarks;

  /** \brief The coordinates, without a copy; valid as long as \ref cloud is unchanged. */
  acmap::PointView
  points() const;
};

/** \brief Reads a point cloud: PCD (ascii, binary, binary_compressed), PLY (ascii, both
 * binary orders; vertices only), OBJ (vertices only), XYZ (rows of x y z, more columns
 * ignored). The ending of the name tells which, in any case.
 *
 * The header is compared with the size of the file before memory is taken for the points.
 * \param[in] path the file
 * \throws InputFileException naming file and fault: missing, a folder, empty, truncated,
 * not of its format, a header that lies about its counts
 */
PointCloudFile
loadPointCloud(const std::string& path);

} // namespace pcl
