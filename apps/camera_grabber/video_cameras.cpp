#include "video_cameras.h"

#include "command_line.h"

#include <pcl/core/fields_json.h>
#include <pcl/video/camera_grabber.h>
#include <pcl/video/video_source.h>

#include <CLI/CLI.hpp>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

const CameraTexts&
texts()
{
  static const CameraTexts all = {
      "List the cameras of the system and stop",
      "The cameras of the rig in the order reference, horizontal, vertical: their "
      "numbers as --list has them, or device files, video files, or pipelines of "
      "GStreamer that end with appsink; or the folder of a recording, which opens "
      "like a camera",
      "CAMERA..|SESSION",
      3,
      "Frames a second of a stream [default: the rate of the cameras]",
      "",
      "Gain, in units of the driver [default: as the camera is set]",
      "G",
      1e6,
      "--format --warm-up --discard --max-change"};
  return all;
}

std::string
textOfSeconds(const std::optional<double>& seconds)
{
  return seconds ? shortNumber(*seconds) + " s" : "not told";
}

/** \brief The cameras of the tool. */
class VideoCameras : public GrabbedCamera {
public:
  VideoCameras(const CameraOptions& options, const TrinocularRig& rig)
  : options_(options)
  , cameras_(new CameraGrabber(rig, options.devices))
  {
    setUp();
  }

  shared_ptr<TrinocularGrabber>
  grabber() const override
  {
    return cameras_;
  }

  double
  shotTimeout() const override
  {
    constexpr double slowest_rate = 5; // Hz, of common cameras
    const unsigned images = cameras_->getWarmUpFrames() +
                            cameras_->getDiscardedFrames() +
                            cameras_->getMaximumRetries() + 2;
    return cameras_->getTimeout() + images / slowest_rate;
  }

  void
  count(GrabStatus& status) const override
  {
    const CameraGrabberReport report = cameras_->getReport();
    status.frames_per_second = report.frames_per_second;
    status.broken = report.broken;
  }

  void
  tell(StageLog& log) const override
  {
    const CameraGrabberReport report = cameras_->getReport();
    for (const CameraState& camera : report.cameras) {
      const char* const exposure = camera.is_recording        ? "a recording"
                                   : camera.is_exposure_fixed ? "exposure fixed"
                                                              : "exposure not fixed";
      log.tell("camera",
               camera.device + ", " + shortNumber(camera.frames_per_second) +
                   " images/s, " + exposure +
                   (camera.exposure ? ", " + textOfSeconds(camera.exposure) : ""));
    }
    log.warn(report.remarks);
    log.tell("still",
             "largest change " + shortNumber(report.largest_change) + " grey levels, " +
                 std::to_string(report.moved) + " images of a moving scene left out");
    log.details.update(fieldsOf(report, {{"frames"}, {"frames_per_second"}}));
  }

private:
  void
  setUp()
  {
    CameraGrabber& cameras = *cameras_;
    cameras.setPixelFormat(options_.format);
    if (options_.rate)
      cameras.setFramesPerSecond(static_cast<float>(*options_.rate));
    if (options_.warm_up)
      cameras.setWarmUpFrames(*options_.warm_up);
    if (options_.discard)
      cameras.setDiscardedFrames(*options_.discard);
    if (options_.max_change)
      cameras.setMaximumChange(*options_.max_change);
    if (options_.shutter.is_auto)
      cameras.setAutomaticExposure(true);
    if (options_.shutter.number)
      cameras.setExposure(*options_.shutter.number);
    if (options_.gain.number)
      cameras.setGain(*options_.gain.number);
  }

  const CameraOptions& options_;
  shared_ptr<CameraGrabber> cameras_;
};

void
addOwnOptions(CLI::App& app, CameraOptions& options)
{
  app.add_option("--format",
                 options.format,
                 "Format in which the cameras send images, MJPG or YUYV "
                 "[default: as the cameras are set]")
      ->type_name("FOUR")
      ->default_str("");
  app.add_option("--warm-up",
                 options.warm_up,
                 "Images that are thrown away at the start, while automatic exposure "
                 "settles [default: 10]")
      ->type_name("N")
      ->default_str("")
      ->check(CLI::Range(0u, 10000u).description(""));
  app.add_option("--discard",
                 options.discard,
                 "Images that are thrown away before each shot, since drivers buffer "
                 "older ones [default: 5]")
      ->type_name("N")
      ->default_str("")
      ->check(CLI::Range(0u, 1000u).description(""));
  app.add_option("--max-change",
                 options.max_change,
                 "Change between two successive images up to which the scene stands "
                 "still, grey levels; 255 for no check [default: 4]")
      ->type_name("LEVELS")
      ->default_str("")
      ->check(positiveNumber(255).description(""));
}

} // namespace

void
addOptions(Tool& tool, CameraOptions& options)
{
  options.tool = "pcl_camera_grabber";
  addOptions(tool, static_cast<GrabberOptions&>(options), texts(), [&](CLI::App& app) {
    addOwnOptions(app, options);
  });
}

void
requireSense(Tool& tool, const CameraOptions& options)
{
  requireSense(tool, static_cast<const GrabberOptions&>(options), texts());
  if (!options.list && options.devices.empty())
    throw UsageError("--device is needed, the cameras of the rig, say --device 0 2");
  if (options.gain.is_auto)
    throw UsageError("--gain auto: the cameras choose their gain unless it is given");
}

void
listVideoCameras(StageLog& log)
{
  const std::vector<SystemCamera> cameras = listSystemCameras();
  if (cameras.empty())
    throw NothingFound("the system has no camera (/dev/video...)");
  Json& list = log.details["cameras"];
  for (const SystemCamera& camera : cameras) {
    log.tell(std::to_string(camera.number), camera.name);
    list.push_back({{"number", camera.number}, {"name", camera.name}});
  }
}

std::unique_ptr<GrabbedCamera>
openVideoCameras(const CameraOptions& options, const TrinocularRig& rig)
{
  return std::make_unique<VideoCameras>(options, rig);
}

} // namespace pcl::acmap
