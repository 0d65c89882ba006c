#include "device.h"

#include "active_stereo/frame_rectifier.h"

#include <pcl/acquisition/usb_camera.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace pcl::acmap {

namespace {

constexpr float fastest = 1000; // frames per second of a recording

Device
openRecording(const GrabberOptions& options)
{
  Device device;
  device.recording.reset(new TrinocularFileGrabber(options.device, fastest));
  device.recording->setSkipBroken(true);
  device.rig = device.recording->getRig();
  return device;
}

Device
openCamera(const GrabberOptions& options)
{
  Device device;
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
  return device;
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

} // namespace

TrinocularGrabber&
Device::frames() const
{
  return *framesPointer();
}

shared_ptr<TrinocularGrabber>
Device::framesPointer() const
{
  if (camera)
    return camera;
  return recording;
}

std::size_t
Device::frameBytes() const
{
  constexpr std::size_t bytes_per_pixel = 9; // three cameras, in colour
  return bytes_per_pixel * static_cast<std::size_t>(rig.width) *
         static_cast<std::size_t>(rig.height);
}

Device
openDevice(const GrabberOptions& options)
{
  const std::string rig = options.rigPath();
  Device device = options.isRecording() ? openRecording(options) : openCamera(options);
  if (hasBuiltCameras(rig))
    device.cameras = loadRigCalibration(rig);
  if (device.camera && device.cameras)
    device.camera->setCalibration(*device.cameras);
  return device;
}

void
listCameras(Tool& tool)
{
  const std::vector<UsbCamera> cameras = listUsbCameras();
  if (cameras.empty())
    throw NothingFound("no camera that speaks IIDC is on the USB");
  nlohmann::ordered_json& list = tool.details()["cameras"];
  for (const UsbCamera& camera : cameras) {
    const bool is_fine = camera.fault == CameraFault::None;
    char id[16];
    std::snprintf(id, sizeof(id), "%04x:%04x", camera.vendor, camera.product);
    std::string text =
        is_fine ? camera.serial + ", " + camera.maker + ", " + camera.model
                : std::string(id) + ", " + nameOf(camera.fault) + ": " + camera.message;
    if (is_fine && !camera.speed.empty())
      text += ", " + camera.speed;
    tool.tell(camera.place, text);
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
  constexpr std::array cameras = {
      RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};
  std::istringstream words(text);
  std::vector<RigCamera> order;
  for (std::string word; std::getline(words, word, ',');)
    for (const RigCamera camera : cameras) {
      const std::string name = nameOf(camera);
      const bool is_new = std::count(order.begin(), order.end(), camera) == 0;
      if (is_new && (word == name || word == name.substr(0, 1)))
        order.push_back(camera);
    }
  const auto commas = std::count(text.begin(), text.end(), ',');
  if (order.size() != cameras.size() || commas != 2)
    throw UsageError("--channel-order: " + text +
                     " is neither auto nor an order of r,h,v");
  return ChannelOrder{order[0], order[1], order[2]};
}

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

} // namespace pcl::acmap
