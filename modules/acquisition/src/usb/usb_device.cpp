#include "usb_device.h"

#include <libusb.h>

namespace pcl::acmap {

namespace {

std::string
speedOf(libusb_device& device)
{
  switch (libusb_get_device_speed(&device)) {
  case LIBUSB_SPEED_LOW:
    return "1.5 Mb/s";
  case LIBUSB_SPEED_FULL:
    return "12 Mb/s";
  case LIBUSB_SPEED_HIGH:
    return "480 Mb/s";
  case LIBUSB_SPEED_SUPER:
    return "5000 Mb/s";
  case LIBUSB_SPEED_SUPER_PLUS:
    return "10000 Mb/s";
  default:
    return "";
  }
}

CameraFault
faultOf(int error)
{
  switch (error) {
  case LIBUSB_ERROR_ACCESS:
    return CameraFault::PermissionDenied;
  case LIBUSB_ERROR_NO_DEVICE:
    return CameraFault::Unplugged;
  case LIBUSB_ERROR_BUSY:
    return CameraFault::Busy;
  case LIBUSB_ERROR_TIMEOUT:
    return CameraFault::Silent;
  case LIBUSB_ERROR_PIPE:
    return CameraFault::Unsupported;
  default:
    return CameraFault::Failed;
  }
}

const char*
helpFor(int error)
{
  switch (error) {
  case LIBUSB_ERROR_ACCESS:
    return "; copy acmap's udev rule, 70-acmap-digiclops.rules, to /etc/udev/rules.d, "
           "then plug the camera in again";
  case LIBUSB_ERROR_BUSY:
    return "; another program has it";
  case LIBUSB_ERROR_NO_MEM:
    return "; how much there may be: /sys/module/usbcore/parameters/usbfs_memory_mb";
  default:
    return "";
  }
}

} // namespace

UsbContext
makeUsbContext()
{
  libusb_context* context = nullptr;
  checkUsb(libusb_init(&context), "usb", "starting libusb");
  return UsbContext(context, libusb_exit);
}

std::vector<UsbDevice>
usbDevices(libusb_context& context)
{
  libusb_device** list = nullptr;
  const ssize_t count = libusb_get_device_list(&context, &list);
  checkUsb(static_cast<int>(count), "usb", "looking for devices");
  std::vector<UsbDevice> devices;
  devices.reserve(static_cast<std::size_t>(count));
  for (ssize_t i = 0; i < count; ++i)
    devices.emplace_back(list[i]);
  libusb_free_device_list(list, 0); // the references to the devices are kept
  return devices;
}

UsbCamera
describe(libusb_device& device)
{
  libusb_device_descriptor descriptor{};
  libusb_get_device_descriptor(&device, &descriptor); // cached: does not fail
  UsbCamera camera;
  camera.place = std::to_string(libusb_get_bus_number(&device)) + ":" +
                 std::to_string(libusb_get_device_address(&device));
  camera.vendor = descriptor.idVendor;
  camera.product = descriptor.idProduct;
  camera.speed = speedOf(device);
  return camera;
}

UsbHandle
openUsbDevice(libusb_device& device)
{
  libusb_device_handle* handle = nullptr;
  const int result = libusb_open(&device, &handle);
  if (result < 0)
    failUsb(result, "usb " + describe(device).place, "opening");
  return UsbHandle(handle);
}

void
failUsb(int error, const std::string& place, const std::string& doing)
{
  const CameraFault fault = faultOf(error);
  throw CameraException(fault,
                        place + ": " + doing + ": " + nameOf(fault) + " (" +
                            libusb_strerror(error) + ")" + helpFor(error));
}

void
checkUsb(int result, const std::string& place, const std::string& doing)
{
  if (result < 0)
    failUsb(result, place, doing);
}

} // namespace pcl::acmap
