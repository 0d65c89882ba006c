#include "device.h"

#include "active_stereo/frame_rectifier.h"
#include "camera_settings.h"

#include <pcl/acquisition/usb_camera.h>

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

} // namespace pcl::acmap
