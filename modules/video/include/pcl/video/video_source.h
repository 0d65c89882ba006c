#pragma once

#include <pcl/core/camera_exception.h>
#include <pcl/core/export.h>
#include <pcl/core/trinocular_frame.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Settings of a camera. \ingroup video */
enum class VideoSetting {
  Width,                 ///< px
  Height,                ///< px
  FramesPerSecond,       ///< Hz
  PixelFormat,           ///< four characters as a number, the first in the lowest byte
  Exposure,              ///< s
  Gain,                  ///< in units of the driver
  AutomaticExposure,     ///< 0 or 1
  AutomaticWhiteBalance, ///< 0 or 1
  AutomaticFocus         ///< 0 or 1
};

/** \brief One camera, or one video, as \ref CameraGrabber uses it. \ref openVideo opens
 * those that OpenCV supports; implement this interface for others.
 *
 * Its members are called by one thread at a time. \ref grab may block for as long as
 * the driver blocks. \ingroup video */
class ACMAP_EXPORT VideoSource {
public:
  virtual ~VideoSource() = default;

  /** \brief Takes the next image from the camera, without converting it.
   * \return false at the end of a video, or if the camera is gone */
  virtual bool
  grab() = 0;

  /** \brief Converts the image that was grabbed.
   * \param[out] image 1 channel, or red, green, blue
   * \return false if the image is incomplete
   * \throws CameraException (Unsupported) for an image of another type than 8 bits */
  virtual bool
  retrieve(CameraImage& image) = 0;

  /** \brief Time of the image that was grabbed, microseconds. For a recording: its
   * position in the video, otherwise the time of the host. */
  virtual std::uint64_t
  stamp() const = 0;

  /** \brief Has it an end, as a file? */
  virtual bool
  isRecording() const = 0;

  /** \return false if the camera does not have this setting or refuses the value */
  virtual bool
  set(VideoSetting setting, double value) = 0;

  /** \return nothing if the camera does not tell */
  virtual std::optional<double>
  get(VideoSetting setting) const = 0;
};

/** \brief Opens a camera by its name. \ingroup video */
using VideoOpener =
    std::function<std::unique_ptr<VideoSource>(const std::string& device)>;

/** \brief Opens a camera or a video with OpenCV's VideoCapture.
 * \param[in] device a number (of `/dev/video0` ...), a device file of V4L2, a video
 * file, images with numbered names as `left_%04d.png`, a URL, or a pipeline of GStreamer
 * that ends with `appsink`
 * \throws CameraException NotFound, PermissionDenied; Unsupported if this OpenCV has no
 * support for that kind of device; Failed if OpenCV cannot open it
 * \throws InputFileException for a file that is no video \ingroup video */
ACMAP_EXPORT std::unique_ptr<VideoSource>
openVideo(const std::string& device);

/** \brief A camera that the kernel lists. \ingroup video */
struct SystemCamera {
  int number = 0;   ///< of /dev/video0 and so on, as \ref openVideo takes it
  std::string name; ///< as its driver tells it
};

/** \brief The cameras of Video4Linux in the order of their numbers; of a camera with several
 * device files the first one, which gives the images. None where there is no Linux.
 * \ingroup video */
ACMAP_EXPORT std::vector<SystemCamera>
listSystemCameras();

} // namespace pcl
