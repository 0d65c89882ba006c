#include "digiclops_camera.h"

#include "command_line.h"

#include <pcl/acquisition/digiclops_grabber.h>
#include <pcl/acquisition/usb_camera.h>
#include <pcl/core/fields_json.h>

#include <CLI/CLI.hpp>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

constexpr double paper_rate = 14; // Hz

const CameraTexts&
texts()
{
  static const CameraTexts all = {
      "List the cameras on the USB and stop",
      "Camera: its serial number, BUS:ADDRESS as --list has it, or "
      "usb:VENDOR:PRODUCT for a bridge; or the folder of a recording, which "
      "opens like a camera [default: the first camera that can be opened]",
      "ID|SESSION",
      1,
      "Frames a second of a stream",
      "14",
      "Gain, dB [default: as the camera is set]",
      "DB",
      100,
      "--mode --trigger --channel-order"};
  return all;
}

IidcMode
modeOf(const IidcCamera& camera, const std::string& wanted)
{
  std::string all;
  for (const IidcMode& mode : camera.modes()) {
    if (std::to_string(mode.format) + ":" + std::to_string(mode.mode) == wanted)
      return mode;
    all += (all.empty() ? "" : ", ") + mode.text();
  }
  throw UsageError("--mode: the camera has no mode " + wanted + "; it has " +
                   (all.empty() ? "none" : all));
}

void
setFeature(IidcCamera& camera, IidcFeature feature, const NumberOrAuto& wanted)
{
  if (wanted.is_auto)
    camera.setAutomatic(feature);
  else if (wanted.number)
    camera.setPhysical(feature, static_cast<float>(*wanted.number));
}

/** \brief Sets mode, rate, shutter, gain, trigger and channel order. */
void
setUpCamera(DigiclopsGrabber& grabber, const DigiclopsOptions& options)
{
  if (const auto order = channelOrderOf(options.channel_order))
    grabber.setChannelOrder(*order);
  if (!options.mode.empty())
    grabber.setMode(modeOf(grabber.camera(), options.mode));
  grabber.setFramesPerSecond(static_cast<float>(options.rate.value_or(paper_rate)));
  setFeature(grabber.camera(), IidcFeature::Shutter, options.shutter);
  setFeature(grabber.camera(), IidcFeature::Gain, options.gain);
  grabber.camera().setTrigger(options.trigger == "external" ? IidcTrigger::External
                                                            : IidcTrigger::Off);
}

/** \brief Lets the grabber find the order of its channels under patterns. Reports it, or
 * warns if it remains uncertain. */
void
checkOrder(DigiclopsGrabber& camera,
           PatternProjector& projector,
           const std::vector<RgbImage>& patterns,
           StatusLine& status,
           StageLog& log)
{
  const auto check = checkChannelOrder(camera, projector, patterns, stopIfInterrupted);
  const std::string order = textOf(camera.getChannelOrder());
  if (check && check->is_certain)
    status.note("channels are " + order + ": " + shortNumber(100 * check->share) +
                " % of the corners agree, under the next order " +
                shortNumber(100 * check->runner_up) + " %");
  else
    log.warn("the order of the channels could not be checked, it is taken as " + order);
}

/** \brief The camera of the tool. */
class DigiclopsCamera : public GrabbedCamera {
public:
  DigiclopsCamera(const DigiclopsOptions& options, const TrinocularRig& rig)
  : options_(options)
  , camera_(new DigiclopsGrabber(
        rig, options.devices.empty() ? std::string() : options.devices.front()))
  {
    setUpCamera(*camera_, options);
  }

  shared_ptr<TrinocularGrabber>
  grabber() const override
  {
    return camera_;
  }

  void
  setCalibration(const RigCalibration& cameras) override
  {
    camera_->setCalibration(cameras);
  }

  void
  check(PatternProjector& projector,
        const std::vector<RgbImage>& patterns,
        StatusLine& status,
        StageLog& log) override
  {
    // with fewer cameras the order cannot be determined
    if (options_.channel_order == "auto" && camera_->getMode().cameras() == 3)
      checkOrder(*camera_, projector, patterns, status, log);
  }

  double
  shotTimeout() const override
  {
    constexpr double shot_timeout = 5; // seconds, in addition to the exposure
    // seconds; an external trigger may take longer
    constexpr double external_timeout = 60;
    return options_.trigger == "external"
               ? external_timeout
               : shot_timeout + 3 * options_.shutter.number.value_or(0.0);
  }

  void
  count(GrabStatus& status) const override
  {
    const DigiclopsGrabberReport report = camera_->getReport();
    status.frames_per_second = report.frames_per_second;
    status.lost = report.lost;
    status.broken = report.broken;
  }

  void
  tell(StageLog& log) const override
  {
    DigiclopsGrabber& grabber = *camera_;
    const IidcIdentity identity = grabber.camera().identity();
    const DigiclopsGrabberReport report = grabber.getReport();
    const std::string order = textOf(grabber.getChannelOrder());
    Json& details = log.details["camera"];
    details = {{"place", grabber.camera().place()},
               {"serial", identity.serial()},
               {"maker", identity.maker},
               {"model", identity.model},
               {"iidc", identity.version},
               {"mode", grabber.getMode().text()},
               {"rate", grabber.getFramesPerSecond()}};
    details.update(fieldsOf(report, {{"frames"}, {"frames_per_second"}}));
    details["channel_order"] = order;
    log.warn(report.remarks);
    log.tell("camera",
             identity.serial() + ", " + identity.maker + ", " + identity.model + ", " +
                 grabber.camera().place());
    log.tell("mode", grabber.getMode().text() + ", channels " + order);
    log.tell("lost",
             std::to_string(report.lost) + ", broken " + std::to_string(report.broken) +
                 ", restarts " + std::to_string(report.restarts));
  }

private:
  const DigiclopsOptions& options_;
  shared_ptr<DigiclopsGrabber> camera_;
};

void
addOwnOptions(CLI::App& app, DigiclopsOptions& options)
{
  app.add_option("--mode",
                 options.mode,
                 "IIDC format and mode, say 7:0 [default: the first that fits the rig]")
      ->type_name("F:M")
      ->default_str("");
  addChoice<std::string>(
      app,
      "--trigger",
      options.trigger,
      {{"off", "off"}, {"external", "external"}},
      "what exposes a frame: the camera by itself (off), or its input (external)");
  app.add_option("--channel-order",
                 options.channel_order,
                 "Cameras of a pixel's bytes, some order of r,h,v (reference, "
                 "horizontal, vertical); auto finds it out")
      ->type_name("R,H,V|auto");
}

} // namespace

void
addOptions(Tool& tool, DigiclopsOptions& options)
{
  options.tool = "pcl_digiclops_grabber";
  addOptions(tool, static_cast<GrabberOptions&>(options), texts(), [&](CLI::App& app) {
    addOwnOptions(app, options);
  });
}

std::optional<ChannelOrder>
channelOrderOf(const std::string& text)
{
  if (text == "auto")
    return std::nullopt;
  try {
    return channelOrderIn(text);
  }
  catch (const BadArgumentException&) {
    throw UsageError("--channel-order: " + text +
                     " is neither auto nor an order of r,h,v");
  }
}

void
requireSense(Tool& tool, const DigiclopsOptions& options)
{
  requireSense(tool, static_cast<const GrabberOptions&>(options), texts());
  // Both are measured with additional shots, for which there is no external trigger.
  if (!options.list && !options.isRecording() && !options.isStream() &&
      options.trigger == "external" &&
      (options.settle.is_auto || options.channel_order == "auto"))
    throw UsageError("--trigger external with patterns needs --channel-order, and "
                     "--settle in seconds");
  channelOrderOf(options.channel_order);
}

void
listDigiclopsCameras(StageLog& log)
{
  const std::vector<UsbCamera> cameras = listUsbCameras();
  if (cameras.empty())
    throw NothingFound("no camera that speaks IIDC is on the USB");
  nlohmann::ordered_json& list = log.details["cameras"];
  for (const UsbCamera& camera : cameras) {
    const bool is_fine = camera.fault == CameraFault::None;
    char id[16];
    std::snprintf(id, sizeof(id), "%04x:%04x", camera.vendor, camera.product);
    std::string text =
        is_fine ? camera.serial + ", " + camera.maker + ", " + camera.model
                : std::string(id) + ", " + nameOf(camera.fault) + ": " + camera.message;
    if (is_fine && !camera.speed.empty())
      text += ", " + camera.speed;
    log.tell(camera.place, text);
    list.push_back({{"place", camera.place},
                    {"id", id},
                    {"speed", camera.speed},
                    {"serial", camera.serial},
                    {"maker", camera.maker},
                    {"model", camera.model},
                    {"fault", nameOf(camera.fault)},
                    {"message", camera.message}});
  }
}

std::unique_ptr<GrabbedCamera>
openDigiclopsCamera(const DigiclopsOptions& options, const TrinocularRig& rig)
{
  return std::make_unique<DigiclopsCamera>(options, rig);
}

} // namespace pcl::acmap
