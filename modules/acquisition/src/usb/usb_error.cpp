#include "usb_error.h"

#include <libusb.h>

namespace pcl::acmap {

namespace {

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
