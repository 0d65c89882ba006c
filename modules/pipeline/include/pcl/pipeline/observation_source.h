#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/bag_settings.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief A file that has several observations, for an ObservationSequence. Derive from it
 * to map a format of your own. Thread-safe. \ingroup pipeline */
class ACMAP_EXPORT ObservationSource {
public:
  virtual ~ObservationSource() = default;

  /** \brief Name for messages, such as the path of the file. */
  virtual std::string
  name() const = 0;

  /** \brief Number of observations, at least 1. */
  virtual std::size_t
  size() const = 0;

  /** \brief Times and poses T_map_camera of all observations, metres; without poses if they
   * are not known. */
  virtual Trajectory
  trajectory() const = 0;

  /** \brief Reads an observation, camera frame, metres.
   * \throws InputFileException if it is malformed */
  virtual PointCloudFile
  load(std::size_t i) const = 0;

  /** \brief Name of the file of an observation in a folder of them, each another one
   * (default: observation_0000.pcd and so on). */
  virtual std::string
  nameOf(std::size_t i) const;

  /** \brief What was subtracted from the coordinates of the file, CompactMap::shift. */
  virtual Eigen::Vector3d
  shift() const
  {
    return Eigen::Vector3d::Zero();
  }

  /** \brief Changes with the observations, but is known without reading them: by name, size
   * and time of their file. Empty: they are read to detect a change. */
  virtual std::string
  fingerprint() const
  {
    return {};
  }

  /** \brief Warnings about the file, one per line. */
  virtual std::vector<std::string>
  remarks() const
  {
    return {};
  }
};

/** \brief The scans of an E57 or PTX file (\ref ScanFile), with their poses and their numbers
 * as times.
 * \param[in] shift to be subtracted from coordinates; none: found
 * \throws InputFileException as \ref ScanFile \ingroup pipeline */
ACMAP_EXPORT std::shared_ptr<const ObservationSource>
openScans(const std::string& path, const std::optional<Eigen::Vector3d>& shift = {});

/** \brief The observations of a bag of ROS 1 or ROS 2 (\ref BagFile): of RGB-D images with
 * their CameraInfo, or of PointCloud2. Of several topics of a kind the one with most messages
 * is taken; of depths, those that are registered to colours.
 *
 * Poses are those of the tree of transforms (tf, tf_static, Odometry, TransformStamped, else
 * PoseStamped, PoseWithCovarianceStamped, Path) at
 * the times of the observations, relative to the first one; those without a pose are left
 * out. Without any pose of a frame that moves, there are none. Clouds in a frame of a body
 * (x ahead, z up) are turned to that of a camera.
 * \throws InputFileException as \ref BagFile; if there are no images of depth with colour
 * and camera and no clouds, a message is malformed, or the place of a camera on what moves is
 * neither in the bag nor in the settings
 * \throws BadArgumentException if BagSettings::every is 0, or the place of the sensor is
 * stated and the bag has it \ingroup pipeline */
ACMAP_EXPORT std::shared_ptr<const ObservationSource>
openBag(const std::string& path, const BagSettings& settings = {});

} // namespace pcl
