#include "video_device.h"

#include <pcl/video/video_source.h>

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/videoio.hpp>
#include <opencv2/videoio/registry.hpp>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <utility>

namespace pcl {

namespace {

using acmap::VideoDevice;
using acmap::VideoKind;

/** \brief Suppresses OpenCV's own warnings, whose causes become exceptions, unless the
 * user asks for them. The level is that of the process, and several threads may read
 * cameras: the first one sets it, the last one restores it. */
class QuietOpenCv {
public:
  QuietOpenCv()
  {
    const std::lock_guard lock(mutex_);
    if (users_++ > 0 || std::getenv("OPENCV_LOG_LEVEL"))
      return;
    level_ = cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  }

  ~QuietOpenCv()
  {
    const std::lock_guard lock(mutex_);
    if (--users_ == 0 && !std::getenv("OPENCV_LOG_LEVEL"))
      cv::utils::logging::setLogLevel(level_);
  }

  QuietOpenCv(const QuietOpenCv&) = delete;
  QuietOpenCv&
  operator=(const QuietOpenCv&) = delete;

private:
  static inline std::mutex mutex_;
  static inline int users_ = 0;
  static inline cv::utils::logging::LogLevel level_ =
      cv::utils::logging::LOG_LEVEL_WARNING;
};

cv::VideoCaptureAPIs
backendOf(VideoKind kind)
{
  switch (kind) {
  case VideoKind::Camera:
    return cv::CAP_V4L2;
  case VideoKind::Images:
    return cv::CAP_IMAGES;
  case VideoKind::Pipeline:
    return cv::CAP_GSTREAMER;
  default:
    return cv::CAP_FFMPEG;
  }
}

[[noreturn]] void
throwNotOpened(const VideoDevice& device)
{
  const cv::VideoCaptureAPIs backend = backendOf(device.kind);
  if (!cv::videoio_registry::hasBackend(backend))
    throw CameraException(CameraFault::Unsupported,
                          device.name + ": this OpenCV has no " +
                              cv::videoio_registry::getBackendName(backend));
  switch (device.kind) {
  case VideoKind::File:
    throw InputFileException(device.name + ": is no video that OpenCV can read");
  case VideoKind::Images:
    throw InputFileException(device.name + ": there are no such images");
  case VideoKind::Camera:
    throw CameraException(CameraFault::Failed,
                          device.name + ": cannot be opened: is it a camera, and does "
                                        "no other program use it?");
  case VideoKind::Pipeline:
    throw CameraException(CameraFault::Failed,
                          device.name +
                              ": GStreamer does not accept this pipeline: are its "
                              "plugins installed, and does it end with appsink?");
  default:
    throw CameraException(CameraFault::Failed, device.name + ": cannot be opened");
  }
}

/** \brief Unit of V4L2's exposure time, seconds. */
constexpr double v4l_exposure_unit = 1e-4;
/** \brief Values of V4L2's V4L2_CID_EXPOSURE_AUTO. */
constexpr double v4l_exposure_manual = 1;
constexpr double v4l_exposure_by_aperture = 3;

int
propertyOf(VideoSetting setting)
{
  switch (setting) {
  case VideoSetting::Width:
    return cv::CAP_PROP_FRAME_WIDTH;
  case VideoSetting::Height:
    return cv::CAP_PROP_FRAME_HEIGHT;
  case VideoSetting::FramesPerSecond:
    return cv::CAP_PROP_FPS;
  case VideoSetting::PixelFormat:
    return cv::CAP_PROP_FOURCC;
  case VideoSetting::Exposure:
    return cv::CAP_PROP_EXPOSURE;
  case VideoSetting::Gain:
    return cv::CAP_PROP_GAIN;
  case VideoSetting::AutomaticExposure:
    return cv::CAP_PROP_AUTO_EXPOSURE;
  case VideoSetting::AutomaticWhiteBalance:
    return cv::CAP_PROP_AUTO_WB;
  default:
    return cv::CAP_PROP_AUTOFOCUS;
  }
}

class OpenCvVideo : public VideoSource {
public:
  explicit OpenCvVideo(const VideoDevice& device)
  : device_(device)
  {
    const QuietOpenCv quiet;
    if (!capture_.open(device.name, backendOf(device.kind)))
      throwNotOpened(device);
    frame_count_ = capture_.get(cv::CAP_PROP_FRAME_COUNT);
  }

  bool
  grab() override
  {
    const QuietOpenCv quiet;
    if (!capture_.grab())
      return false;
    using Microseconds = std::chrono::microseconds;
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    stamp_ = isRecording() ? positionOfImage()
                           : static_cast<std::uint64_t>(
                                 std::chrono::duration_cast<Microseconds>(now).count());
    return true;
  }

  bool
  retrieve(CameraImage& image) override
  {
    const QuietOpenCv quiet;
    if (!capture_.retrieve(pixels_) || pixels_.empty())
      return false;
    if (pixels_.type() != CV_8UC1 && pixels_.type() != CV_8UC3)
      throw CameraException(CameraFault::Unsupported,
                            device_.name + ": gives images that have neither one nor "
                                           "three channels of 8 bits");
    image.width = pixels_.cols;
    image.height = pixels_.rows;
    image.channels = pixels_.channels();
    const auto row_values = static_cast<std::size_t>(pixels_.cols * pixels_.channels());
    image.values.resize(row_values * static_cast<std::size_t>(pixels_.rows));
    for (int row = 0; row < pixels_.rows; ++row)
      std::memcpy(&image.values[static_cast<std::size_t>(row) * row_values],
                  pixels_.ptr(row),
                  row_values);
    if (image.channels == 3) // blue, green, red
      for (std::size_t i = 0; i < image.values.size(); i += 3)
        std::swap(image.values[i], image.values[i + 2]);
    return true;
  }

  std::uint64_t
  stamp() const override
  {
    return stamp_;
  }

  bool
  isRecording() const override
  {
    return device_.kind == VideoKind::Images ||
           (device_.kind == VideoKind::File && frame_count_ > 0);
  }

  bool
  set(VideoSetting setting, double value) override
  {
    // OpenCV restarts a pipeline for each setting, also for those that it has not.
    if (device_.kind != VideoKind::Camera)
      return false;
    const QuietOpenCv quiet;
    if (setting == VideoSetting::Exposure)
      value /= v4l_exposure_unit;
    if (setting == VideoSetting::AutomaticExposure)
      value = value > 0 ? v4l_exposure_by_aperture : v4l_exposure_manual;
    return capture_.set(propertyOf(setting), value);
  }

  std::optional<double>
  get(VideoSetting setting) const override
  {
    const QuietOpenCv quiet;
    double value = capture_.get(propertyOf(setting));
    const bool is_size_or_rate = setting == VideoSetting::Width ||
                                 setting == VideoSetting::Height ||
                                 setting == VideoSetting::FramesPerSecond;
    // Files and pipelines have none of the other settings.
    if (device_.kind == VideoKind::Camera) {
      if (setting == VideoSetting::Exposure)
        value *= v4l_exposure_unit;
      if (setting == VideoSetting::AutomaticExposure)
        value = value == v4l_exposure_manual ? 0 : 1;
    }
    else if (!is_size_or_rate)
      return std::nullopt;
    return value < 0 || (is_size_or_rate && value == 0) ? std::nullopt
                                                        : std::optional(value);
  }

private:
  std::uint64_t
  positionOfImage()
  {
    const double seconds_per_image = 1 / get(VideoSetting::FramesPerSecond).value_or(1);
    return static_cast<std::uint64_t>(1e6 * seconds_per_image *
                                      static_cast<double>(grabbed_++));
  }

  VideoDevice device_;
  cv::VideoCapture capture_;
  cv::Mat pixels_;
  double frame_count_ = 0;
  std::uint64_t grabbed_ = 0;
  std::uint64_t stamp_ = 0;
};

} // namespace

std::unique_ptr<VideoSource>
openVideo(const std::string& device)
{
  return std::make_unique<OpenCvVideo>(acmap::findVideoDevice(device));
}

} // namespace pcl
