#pragma once

#include <pcl/core/export.h>
#include <pcl/core/point_cloud_file.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Reads point clouds (\ref loadPointCloud) with what the caller states of them: the
 * unit, the shift, the columns of a text, the up direction and the sensor. What is not stated and not in the file, others find
 * out from the points (\ref CloudAssessment).
 * \code
 * pcl::PointCloudReader reader;
 * reader.setScale (0.001);                               // a file in millimetres
 * reader.setUpDirection (Eigen::Vector3d::UnitY ());
 * const pcl::PointCloudFile file = reader.read ("room.ply");
 * \endcode
 * A field of colours in which all points are black is left out, with a remark. \ingroup core */
class ACMAP_EXPORT PointCloudReader {
public:
  /** \brief Sets the metres in a unit of the files (default 1).
   * \throws BadArgumentException unless it is within [1e-12, 1e12] */
  void
  setScale(double scale);

  double
  getScale() const
  {
    return scale_.value_or(1);
  }

  /** \brief States what is subtracted from all coordinates, before they become float32
   * (default: \ref PointCloudFile::shift, found from the points of each file).
   * \param[in] shift metres
   * \throws BadArgumentException if it is not finite or beyond 1e9 m */
  void
  setShift(const Eigen::Vector3d& shift);

  /** \brief The shift that was stated; nothing if there is none. */
  const std::optional<Eigen::Vector3d>&
  getShift() const
  {
    return stated_.shift;
  }

  /** \brief States what the columns of a text are, whatever its header says.
   * \param[in] columns names from the first column on: x, y, z, red, green, blue, intensity,
   * normal_x, normal_y, normal_z (also r, g, b, i, nx, ny, nz); - leaves a column out, and so
   * are those that follow
   * \throws BadArgumentException for another name, one that comes twice, or without x, y
   * and z */
  void
  setColumns(const std::vector<std::string>& columns);

  /** \brief States the up direction of the clouds, whatever their files say.
   * \param[in] up of any length above 0
   * \throws BadArgumentException if it is not finite or zero */
  void
  setUpDirection(const Eigen::Vector3d& up);

  /** \brief The up direction that was stated, of length 1; nothing if there is none. */
  const std::optional<Eigen::Vector3d>&
  getUpDirection() const
  {
    return up_;
  }

  /** \brief States that one sensor at this position measured the clouds, whatever their
   * files say. The direction in which it looked stays that of the file.
   * \param[in] origin metres, in the frame of the file, before the shift
   * \throws BadArgumentException if it is not finite or beyond 1e9 m */
  void
  setSensorOrigin(const Eigen::Vector3d& origin);

  /** \brief States that no single sensor measured the clouds. */
  void
  setWithoutSensor();

  /** \throws InputFileException as \ref loadPointCloud */
  PointCloudFile
  read(const std::string& path) const;

  /** \brief Reads a cloud that may be larger than the memory: binary PCD and PLY, LAS, E57
   * and PTX go to the rows block by block; others are in memory before.
   * \param[out] file all that the file has, without the data of its cloud
   * \return the points
   * \throws InputFileException as \ref loadPointCloud */
  CloudRows
  readRows(const std::string& path, PointCloudFile& file) const;

  /** \brief Applies what was stated, but for shift and columns, to a cloud that was read by
   * other means.
   * \param[in,out] file in the unit of its file, then in metres */
  void
  apply(PointCloudFile& file) const;

private:
  void
  state(PointCloudFile& file) const;

  acmap::CloudStatement stated_{1, {}, {}, true};
  std::optional<double> scale_;
  std::optional<Eigen::Vector3d> up_;
  SensorStatement sensor_ = SensorStatement::Unstated;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
};

} // namespace pcl
