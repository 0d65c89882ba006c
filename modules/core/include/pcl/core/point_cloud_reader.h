#pragma once

#include <pcl/core/export.h>
#include <pcl/core/point_cloud_file.h>

#include <Eigen/Core>

#include <optional>
#include <string>

namespace pcl {

/** \brief Reads point clouds (\ref loadPointCloud) with what the caller states of them: the
 * unit, the up direction and the sensor. What is not stated and not in the file, others find
 * out from the points (\ref CloudAssessment).
 * \code
 * pcl::PointCloudReader reader;
 * reader.setScale (0.001);                               // a file in millimetres
 * reader.setUpDirection (Eigen::Vector3d::UnitY ());
 * const pcl::PointCloudFile file = reader.read ("room.ply");
 * \endcode
 * \ingroup core */
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
   * \param[in] origin metres, in the frame of the cloud
   * \throws BadArgumentException if it is not finite or beyond 1e9 m */
  void
  setSensorOrigin(const Eigen::Vector3f& origin);

  /** \brief States that no single sensor measured the clouds. */
  void
  setWithoutSensor();

  /** \throws InputFileException as \ref loadPointCloud */
  PointCloudFile
  read(const std::string& path) const;

  /** \brief Reads a cloud that may be larger than the memory: binary PCD and PLY, LAS and E57
   * go to the rows block by block; others are in memory before.
   * \param[out] file all that the file has, without the data of its cloud
   * \return the points
   * \throws InputFileException as \ref loadPointCloud */
  CloudRows
  readRows(const std::string& path, PointCloudFile& file) const;

  /** \brief Applies what was stated to a cloud that was read by other means.
   * \param[in,out] file in the unit of its file, then in metres */
  void
  apply(PointCloudFile& file) const;

private:
  void
  state(PointCloudFile& file) const;

  std::optional<double> scale_;
  std::optional<Eigen::Vector3d> up_;
  SensorStatement sensor_ = SensorStatement::Unstated;
  Eigen::Vector3f origin_ = Eigen::Vector3f::Zero();
};

} // namespace pcl
