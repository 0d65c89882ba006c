#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/cloud_rows.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/cloud_statement.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/sensor_evidence.h>

#include <Eigen/Geometry>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief What a file or the caller states of the sensor of a cloud. \ingroup core */
enum class SensorStatement {
  Unstated, ///< the position is a hypothesis where it is the default one
  Stated,   ///< the position is the sensor's, whatever the points say
  NoSensor  ///< no single sensor measured the cloud
};

/** \brief A point cloud that was read from a file. \ingroup core */
struct PointCloudFile {
  /** \brief The points with all their scalar fields. The fields x, y, z are adjacent
   * float32, regardless of their type in the file. A colour of three bytes is stored as
   * PCL's packed `rgb`, one of four bytes as `rgba`; the normals of a PLY are named
   * normal_x, normal_y, normal_z. Points that are not finite are kept; in that case
   * `is_dense` is 0. */
  PCLPointCloud2 cloud;

  /** \brief Sensor pose (VIEWPOINT of a PCD; identity for formats without a pose). The identity
   * is what PCL writes if nothing is known: see \ref sensor_statement. */
  Eigen::Vector3f sensor_origin = Eigen::Vector3f::Zero();
  Eigen::Quaternionf sensor_orientation = Eigen::Quaternionf::Identity();

  /** \brief Is the sensor position stated? A pose other than the identity is, too. */
  SensorStatement sensor_statement = SensorStatement::Unstated;

  /** \brief Up direction of the frame, of length 1, if it is known: formats of surveys have
   * heights (LAS: z). */
  std::optional<Eigen::Vector3f> up;

  /** \brief The up direction that is usual in the format, of length 1: assumed where nothing is
   * known and the points do not show another (OBJ: y, national grids: z). */
  std::optional<Eigen::Vector3f> usual_up;

  /** \brief Metres in a unit of the file, of a LAS in x and y, if the caller, the names of its
   * columns or a record of its reference system state it: the cloud is in metres. */
  std::optional<double> stated_scale;

  /** \brief Positions of the sensor that an int32 field `view` refers to, in the frame of
   * the cloud; empty if the file does not know them (known: E57). */
  std::vector<Eigen::Vector3f> viewpoints;

  /** \brief What was subtracted from the coordinates of the file, metres, so that float32
   * keeps their millimetres: the whole kilometres of the middle of the points along the axes
   * along which nearly all are beyond 10 km, as in national grids, else zero. */
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();

  /** \brief How the columns of a text were understood, as "id (left out), x, y, z"; empty for
   * formats that name their fields. */
  std::string columns;

  /** \brief Warnings about the file that did not prevent reading it, one per entry. */
  std::vector<std::string> remarks;

  /** \brief Returns a view of the coordinates without copying them; it is valid as long
   * as \ref cloud is unchanged. */
  ACMAP_EXPORT acmap::PointView
  points() const;
};

/** \brief Reads a point cloud; the format is determined from the file extension
 * (case-insensitive).
 *
 * - PCD: ascii, binary, binary_compressed; any fields. Names in capitals are those of PCL.
 * - PLY: ascii and both binary byte orders; the vertices with their scalar properties.
 * - OBJ: the vertices, with colour if all of them have one (fractions, or 0 to 255 when
 *   one exceeds 1).
 * - XYZ, TXT, CSV, ASC, PTS: rows of numbers, separated by blanks, tabs, commas,
 *   semicolons or bars. The names of a header say what the columns are; without names x, y, z come
 *   first, and colours follow if the numbers are those of colours. What is ambiguous is
 *   refused: see \ref PointCloudReader::setColumns.
 * - LAS: 1.0 to 1.5, point formats 0 to 10: coordinates, `intensity`, `classification`,
 *   and `rgb` where there are colours, of 16 bits if one of them exceeds 255; feet of its
 *   reference system become metres. Packed points (LAZ) are refused.
 * - E57 and PTX: the points of all scans in the frame of the file, with `intensity` and `rgb`
 *   where a scan has them; of several scans, `view` is the number of the scan. Points that
 *   are marked as invalid are NaN. One scan with rows and columns is organized.
 *
 * Coordinates of a national grid are shifted (\ref PointCloudFile::shift) before they become
 * float32, in all formats.
 *
 * The header is compared with the size of the file before memory is allocated for the
 * points: a file of n bytes takes at most 16 n bytes of memory, a compressed one 450 n.
 * Takes linear time.
 * \param[in] path the file
 * \throws InputFileException naming file and fault: missing, a folder, empty,
 * truncated, not in the format of its extension, without points (unless the header
 * declares none), more than 2^31 - 1 points, wrong numbers in the header. \ingroup core
 */
ACMAP_EXPORT PointCloudFile
loadPointCloud(const std::string& path);

} // namespace pcl

namespace pcl::acmap {

/** \brief Returns the cloud of a file, which keeps the file alive. */
inline std::shared_ptr<const PCLPointCloud2>
sharedCloud(const std::shared_ptr<const PointCloudFile>& file)
{
  return {file, &file->cloud};
}

/** \brief Is \ref PointCloudFile::sensor_origin the sensor of a cloud? It is if the file or the
 * caller states it; otherwise the points are asked (\ref assessSensor).
 * \param[in] rows points of the file */
ACMAP_EXPORT SensorEvidence
sensorEvidence(const CloudRows& rows, const PointCloudFile& file);

/** \brief Reads a cloud as stated, in metres.
 * \throws InputFileException as \ref pcl::loadPointCloud */
ACMAP_EXPORT PointCloudFile
loadStatedCloud(const std::string& path, const CloudStatement& stated);

/** \brief Reads a cloud that may be larger than the memory, as \ref loadStatedCloud. Binary
 * PCD and PLY, LAS, E57 and PTX go to the rows block by block; others are in memory before.
 * \param[out] file all that the file has, without the data of its cloud
 * \return the points
 * \throws InputFileException as \ref pcl::loadPointCloud */
ACMAP_EXPORT CloudRows
loadCloudRows(const std::string& path,
              const CloudStatement& stated,
              PointCloudFile& file);

/** \brief Multiplies x, y, z and `sigma` of all points and the position of the sensor
 * by a factor. */
ACMAP_EXPORT void
scaleCloud(PointCloudFile& file, double scale);

} // namespace pcl::acmap
