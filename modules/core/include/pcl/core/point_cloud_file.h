#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/build_config.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/point_view.h>

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pcl {

/** \brief A point cloud as it came from a file. \ingroup core */
struct PointCloudFile {
  /** \brief The points with all their scalar fields. Fields x, y, z are float32 and stand
   * together, whatever the file had. A colour of three bytes became PCL's packed `rgb`,
   * one of four bytes `rgba`; the normals of a PLY became normal_x, normal_y, normal_z.
   * Points that are not finite are kept, and told by `is_dense` being 0. */
  PCLPointCloud2 cloud;

  /** \brief Sensor pose (VIEWPOINT of a PCD; identity where the format has none). */
  Eigen::Vector3f sensor_origin = Eigen::Vector3f::Zero();
  Eigen::Quaternionf sensor_orientation = Eigen::Quaternionf::Identity();

  /** \brief Oddities that did not prevent reading, a line each. */
  std::vector<std::string> remarks;

  /** \brief The coordinates, without a copy; valid as long as \ref cloud is unchanged. */
  ACMAP_EXPORT acmap::PointView
  points() const;
};

/** \brief Reads a point cloud; the ending of the name tells its format, in any case.
 *
 * - PCD: ascii, binary, binary_compressed; any fields.
 * - PLY: ascii and both binary orders; the vertices, with their single values.
 * - OBJ: the vertices, with a colour where all of them have one (fractions, or 0 to 255
 *   when one exceeds 1).
 * - XYZ: rows of x y z between blanks, tabs, commas or semicolons; further columns, and
 *   comments behind # or //, are ignored. A count or names above the rows give a remark.
 *
 * The header is compared with the size of the file before memory is taken for the points:
 * a file of n bytes takes at most 8 n bytes of memory, a compressed one 450 n. Linear time.
 * \param[in] path the file
 * \throws InputFileException naming file and fault: missing, a folder, empty, truncated,
 * not of its format, without a point (a header that says so is believed), more than
 * 2^31 - 1 points, a header that lies about its counts. \ingroup core
 */
ACMAP_EXPORT PointCloudFile
loadPointCloud(const std::string& path);

} // namespace pcl
