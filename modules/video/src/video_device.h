#pragma once

#include <string>

namespace pcl::acmap {

/** \brief The kind of a video source. */
enum class VideoKind { Camera, File, Images, Network, Pipeline };

/** \brief A device, by the name under which OpenCV opens it. */
struct VideoDevice {
  VideoKind kind = VideoKind::File;
  std::string name;
};

/** \brief Determines the kind of a device; a number is that of a V4L2 camera.
 * \throws CameraException NotFound if there is none, PermissionDenied if it may not be
 * opened
 * \throws InputFileException for a folder */
VideoDevice
findVideoDevice(const std::string& device);

/** \brief Do both names mean the same device or file? */
bool
isSameVideo(const std::string& a, const std::string& b);

} // namespace pcl::acmap
