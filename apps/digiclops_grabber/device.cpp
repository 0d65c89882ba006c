#include "device.h"

#include "active_stereo/stereo_shots.h"

#include <pcl/acquisition/usb_camera.h>
#include <pcl/core/rig_cameras.h>

#include <algorithm>
#include <sstream>

namespace pcl::acmap {

namespace {

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
setUpCamera(DigiclopsGrabber& grabber, const GrabberOptions& options)
{
  if (const auto order = channelOrderOf(options.channel_order))
    grabber.setChannelOrder(*order);
  if (!options.mode.empty())
    grabber.setMode(modeOf(grabber.camera(), options.mode));
  grabber.setFramesPerSecond(static_cast<float>(options.rate));
  setFeature(grabber.camera(), IidcFeature::Shutter, options.shutter);
  setFeature(grabber.camera(), IidcFeature::Gain, options.gain);
  grabber.camera().setTrigger(options.trigger == "external" ? IidcTrigger::External
                                                            : IidcTrigger::Off);
}

} // namespace

Device
openDevice(const GrabberOptions& options)
{
  Device device;
  if (options.isRecording()) {
    constexpr float fastest = 1000; // frames per second
    device.recording.reset(new TrinocularFileGrabber(options.device, fastest));
    device.recording->setSkipBroken(true);
    device.rig = device.recording->getRig();
  }
  else {
    device.rig = loadTrinocularRig(options.rig);
    try {
      device.camera.reset(new DigiclopsGrabber(device.rig, options.device));
    }
    catch (const CameraException& error) {
      if (error.fault() == CameraFault::NotFound)
        throw NothingFound(failureOf(std::current_exception()).line);
      throw;
    }
    setUpCamera(*device.camera, options);
  }
  if (hasBuiltCameras(options.rigPath()))
    device.cameras = loadRigCalibration(options.rigPath());
  if (device.camera && device.cameras)
    device.camera->setCalibration(*device.cameras);
  return device;
}

void
listCameras(StageLog& log)
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

std::optional<ChannelOrder>
channelOrderOf(const std::string& text)
{
  if (text == "auto")
    return std::nullopt;
  std::istringstream words(text);
  std::vector<RigCamera> order;
  for (std::string word; std::getline(words, word, ',');)
    for (const RigCamera camera : rig_cameras) {
      const std::string name = nameOf(camera);
      const bool is_new = std::count(order.begin(), order.end(), camera) == 0;
      if (is_new && (word == name || word == name.substr(0, 1)))
        order.push_back(camera);
    }
  const auto commas = std::count(text.begin(), text.end(), ',');
  if (order.size() != rig_cameras.size() || commas != 2)
    throw UsageError("--channel-order: " + text +
                     " is neither auto nor an order of r,h,v");
  return ChannelOrder{order[0], order[1], order[2]};
}

} // namespace pcl::acmap
