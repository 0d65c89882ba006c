#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/image_file.h>
#include <pcl/core/pinhole.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pcl {

/** \brief How a message is serialized: as ROS 2 does by default, or as ROS 1 does.
 * \ingroup core */
enum class RosSerialization { Cdr, Ros1 };

/** \brief Time and frame of a message of ROS. \ingroup core */
struct RosHeader {
  double stamp = 0; ///< seconds
  std::string frame;
};

/** \brief sensor_msgs/msg/Image or CompressedImage. \ingroup core */
struct RosImage {
  RosHeader header;
  std::uint32_t width = 0, height = 0; ///< pixels; 0 for a compressed image
  std::string encoding; ///< such as rgb8, or the format of a compressed one
  bool is_compressed = false;
  bool is_big_endian = false;
  std::uint32_t row_bytes = 0;
  std::string data;

  /** \brief Does its encoding name depths: 16UC1, mono16, 32FC1, compressedDepth? */
  ACMAP_EXPORT bool
  isDepth() const;
};

/** \brief A depth image, metres. \ingroup core */
struct DepthImage {
  std::int32_t width = 0, height = 0; ///< pixels
  std::vector<float> metres;          ///< rows from the top; 0: nothing was measured
};

/** \brief sensor_msgs/msg/CameraInfo: the camera of a rectified image. \ingroup core */
struct RosCameraInfo {
  RosHeader header;
  std::uint32_t width = 0, height = 0; ///< pixels
  Pinhole pinhole;                     ///< pixels
  bool is_distorted = false;           ///< has coefficients of distortion other than 0
};

/** \brief sensor_msgs/msg/PointCloud2 with its fields as \ref PointCloudFile::cloud.
 * \ingroup core */
struct RosCloud {
  RosHeader header;
  PCLPointCloud2 cloud;
};

/** \brief A pose: of geometry_msgs/msg/TransformStamped, nav_msgs/msg/Odometry,
 * geometry_msgs/msg/PoseStamped or PoseWithCovarianceStamped, or one of nav_msgs/msg/Path.
 * \ingroup core */
struct RosTransform {
  RosHeader header;  ///< frame: the parent
  std::string child; ///< frame; empty for poses that name none
  Eigen::Isometry3d T_parent_child = Eigen::Isometry3d::Identity(); ///< metres
};

/** \brief sensor_msgs/msg/LaserScan: ranges in a plane, counter-clockwise about the z axis
 * of its frame, from its x axis. \ingroup core */
struct RosScan {
  RosHeader header;
  double first_angle = 0, angle_step = 0; ///< radians, finite
  double min_range = 0, max_range = 0;    ///< metres; other ranges are no echoes
  std::vector<float> ranges;              ///< metres
};

/** \name Readers of serialized messages, little endian
 * \param[in] bytes of the message
 * \param[in] name of the bag and the topic, for error messages
 * \param[in] serialization of the message
 * \throws InputFileException naming the fault: another serialization, truncated, a length
 * beyond the end, numbers that are not finite where they must be \ingroup core */
///@{
/** \brief The header with which most messages begin. */
ACMAP_EXPORT RosHeader
readRosHeader(std::string_view bytes,
              const std::string& name,
              RosSerialization serialization = RosSerialization::Cdr);

ACMAP_EXPORT RosImage
readRosImage(std::string_view bytes,
             const std::string& name,
             RosSerialization serialization = RosSerialization::Cdr);

ACMAP_EXPORT RosImage
readRosCompressedImage(std::string_view bytes,
                       const std::string& name,
                       RosSerialization serialization = RosSerialization::Cdr);

ACMAP_EXPORT RosCameraInfo
readRosCameraInfo(std::string_view bytes,
                  const std::string& name,
                  RosSerialization serialization = RosSerialization::Cdr);

ACMAP_EXPORT RosCloud
readRosCloud(std::string_view bytes,
             const std::string& name,
             RosSerialization serialization = RosSerialization::Cdr);

ACMAP_EXPORT RosScan
readRosScan(std::string_view bytes,
            const std::string& name,
            RosSerialization serialization = RosSerialization::Cdr);

ACMAP_EXPORT std::vector<RosTransform>
readRosTransforms(std::string_view bytes,
                  const std::string& name,
                  RosSerialization serialization = RosSerialization::Cdr);

ACMAP_EXPORT RosTransform
readRosOdometry(std::string_view bytes,
                const std::string& name,
                RosSerialization serialization = RosSerialization::Cdr);

ACMAP_EXPORT RosTransform
readRosPose(std::string_view bytes,
            const std::string& name,
            RosSerialization serialization = RosSerialization::Cdr);

ACMAP_EXPORT std::vector<RosTransform>
readRosPath(std::string_view bytes,
            const std::string& name,
            RosSerialization serialization = RosSerialization::Cdr);

/** \brief geometry_msgs/msg/Transform, without frames. */
ACMAP_EXPORT Eigen::Isometry3d
readRosBareTransform(std::string_view bytes,
                     const std::string& name,
                     RosSerialization serialization = RosSerialization::Cdr);

/** \brief std_msgs/msg/Float32. */
ACMAP_EXPORT double
readRosNumber(std::string_view bytes,
              const std::string& name,
              RosSerialization serialization = RosSerialization::Cdr);
///@}

/** \brief The colours of an image: rgb8, bgr8, rgba8, bgra8, mono8, 8UC1, 8UC3 or 8UC4, a Bayer
 * pattern of 8 bits, yuv422 or yuv422_yuy2, or a compressed JPEG or PNG.
 * \throws InputFileException for another encoding, or a damaged image \ingroup core */
ACMAP_EXPORT RgbImage
colorsOf(const RosImage& image, const std::string& name);

/** \brief The depths of an image: 16UC1 or mono16 in millimetres, 32FC1 in metres, or these
 * compressed as PNG by compressed_depth_image_transport.
 * \throws InputFileException as \ref colorsOf \ingroup core */
ACMAP_EXPORT DepthImage
depthsOf(const RosImage& image, const std::string& name);

} // namespace pcl
