#pragma once

#include <pcl/acquisition/usb_camera.h>
#include <pcl/core/camera_exception.h>

#include <libusb.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Deleter that calls a function of libusb. */
template <auto function>
struct UsbRelease {
  template <typename Thing>
  void
  operator()(Thing* thing) const
  {
    function(thing);
  }
};

/** \brief Session of libusb, independent of other users of the library. */
using UsbContext = std::shared_ptr<libusb_context>;
using UsbDevice = std::unique_ptr<libusb_device, UsbRelease<libusb_unref_device>>;
using UsbHandle = std::unique_ptr<libusb_device_handle, UsbRelease<libusb_close>>;

/** \brief Vendor of the cameras that are known to tunnel IIDC through USB. */
constexpr std::uint16_t point_grey = 0x1E10;

/** \throws CameraException Failed when USB is not available */
UsbContext
makeUsbContext();

/** \brief All connected devices, not only cameras.
 * \throws CameraException Failed */
std::vector<UsbDevice>
usbDevices(libusb_context& context);

/** \brief Properties of a device that are known without opening it. */
UsbCamera
describe(libusb_device& device);

/** \throws CameraException PermissionDenied, Unplugged, Failed */
UsbHandle
openUsbDevice(libusb_device& device);

/** \brief Throws the CameraException that corresponds to an error of libusb.
 * \param[in] error code of libusb
 * \param[in] place location of the camera, for the message
 * \param[in] doing action that failed, for the message */
[[noreturn]] void
failUsb(int error, const std::string& place, const std::string& doing);

/** \brief Throws when a function of libusb returned an error, which is a negative
 * number. */
void
checkUsb(int result, const std::string& place, const std::string& doing);

} // namespace pcl::acmap
