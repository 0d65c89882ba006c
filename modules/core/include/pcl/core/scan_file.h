#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/point_cloud_file.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief The scans of an E57 or PTX file one by one, as observations, metres.
 *
 * A scan is in the frame of its scanner, turned to that of a camera which looks ahead: x is
 * right, y down, z forward (-y, -z, x of the scanner). The map is the frame of the file.
 * \ref loadPointCloud has all of them in the frame of the file. Copies share what was read
 * when the file was opened; the points are read by \ref load. Thread-safe. \ingroup core */
class ACMAP_EXPORT ScanFile {
public:
  /** \brief Reads the description of the scans, and compares all pages of an E57 file with
   * their checksums.
   * \param[in] shift to be subtracted from coordinates; none: found
   * \throws InputFileException as \ref loadPointCloud */
  explicit ScanFile(const std::string& path,
                    const std::optional<Eigen::Vector3d>& shift = {});

  /** \brief Number of scans of a file; reads only their description, of a PTX all lines.
   * \throws InputFileException as the constructor, but for checksums */
  static std::size_t
  count(const std::string& path);

  /** \brief Number of scans, at least 1. */
  std::size_t
  size() const;

  /** \brief What was subtracted from coordinates in the frame of the file: what was stated,
   * else whole kilometres if they are large, as in national grids, else zero. */
  const Eigen::Vector3d&
  shift() const;

  /** \brief Pose of a scan in the frame of the file less \ref shift. */
  const Eigen::Isometry3d&
  pose(std::size_t i) const;

  /** \brief Warnings about the file, one per line. */
  const std::vector<std::string>&
  remarks() const;

  /** \brief Reads the points of a scan, organized where the file has rows and columns, with
   * `intensity` and `rgb` if it has them, and its \ref pose as sensor. If a scan has
   * coordinates beyond 10 km from its scanner, the pose is not that of the scanner, but of
   * an origin near the points.
   * \throws InputFileException if the points are malformed */
  PointCloudFile
  load(std::size_t i) const;

private:
  struct Content;
  std::shared_ptr<const Content> content_;
};

} // namespace pcl
