#pragma once

#include <pcl/acquisition/usb_camera.h>

#include <libusb.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Calls a function of libusb's at the end of what it made. */
template <auto function>
struct UsbRelease {
  template <typename Thing>
  void
  operator()(Thing* thing) const
  {
    function(thing);
  }
};

/** \brief What one user of libusb has of it, apart from all others. */
using UsbContext = std::shared_ptr<libusb_context>;
using UsbDevice = std::unique_ptr<libusb_device, UsbRelease<libusb_unref_device>>;
using UsbHandle = std::unique_ptr<libusb_device_handle, UsbRelease<libusb_close>>;

/** \brief The maker of the cameras that are known to tunnel IIDC through USB. */
constexpr std::uint16_t point_grey = 0x1E10;

/** \throws CameraException Failed when there is no USB */
UsbContext
makeUsbContext();

/** \brief All that is plugged in, cameras or not.
 * \throws CameraException Failed */
std::vector<UsbDevice>
usbDevices(libusb_context& context);

/** \brief What is known about a device without opening it. */
UsbCamera
describe(libusb_device& device);

/** \throws CameraException PermissionDenied, Unplugged, Failed */
UsbHandle
openUsbDevice(libusb_device& device);

} // namespace pcl::acmap
