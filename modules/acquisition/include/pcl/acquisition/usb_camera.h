#pragma once

#include <pcl/acquisition/iidc_bus.h>
#include <pcl/core/export.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pcl {

/** \brief A camera that speaks IIDC over USB, as a list shows it. \ingroup acquisition */
struct UsbCamera {
  std::string
      place; ///< `BUS:ADDRESS` in decimal, say `1:4`; changes when it is replugged
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string speed; ///< `480 Mb/s`; empty where the system does not say
  std::string
      serial; ///< 16 hexadecimal digits, the camera's GUID; empty when not opened
  std::string maker; ///< as the camera says; empty when not opened
  std::string model; ///< as the camera says; empty when not opened

  /** \brief Why it could not be opened, CameraFault::None when it could. */
  CameraFault fault = CameraFault::None;
  std::string message; ///< of the fault
};

/** \brief Looks for cameras: devices of Point Grey's (vendor 1e10), the only ones known to
 * tunnel IIDC through USB. Each is opened for a moment to ask who it is.
 * \throws CameraException Failed when there is no USB to look at
 * \ingroup acquisition */
ACMAP_EXPORT std::vector<UsbCamera>
listUsbCameras();

/** \brief Opens a camera on the USB.
 *
 * The Digiclops itself is a camera of the IEEE-1394 bus. This speaks IIDC as it is
 * tunnelled over USB: registers by vendor requests of endpoint 0, frames by bulk
 * transfers, each of which is a frame.
 * \param[in] device serial number as in \ref UsbCamera; or `BUS:ADDRESS`; or
 * `usb:VENDOR:PRODUCT` in hexadecimal for a bridge of another maker; empty: the first
 * camera that can be opened
 * \throws BadArgumentException when device is none of these
 * \throws CameraException NotFound, PermissionDenied (the message tells of the udev rule),
 * Busy, Malformed when its descriptors have no stream, Silent when it does not say who it
 * is, Failed
 * \ingroup acquisition */
ACMAP_EXPORT std::unique_ptr<IidcBus>
openUsbBus(const std::string& device = {});

/** \brief Tells when cameras come and go, while it lives. \ingroup acquisition */
class ACMAP_EXPORT UsbCameraWatch {
public:
  /** \brief Called in a thread of the watch; must not destroy it. What it throws is
   * swallowed.
   * \param[in] camera its place, vendor and product; it was not opened
   * \param[in] is_there false: it is gone */
  using Callback = std::function<void(const UsbCamera& camera, bool is_there)>;

  /** \brief Begins; cameras that are there already are told first.
   * \throws CameraException Failed where the system cannot tell */
  explicit UsbCameraWatch(Callback callback);

  /** \brief No callback is called after it. */
  ~UsbCameraWatch();

  UsbCameraWatch(const UsbCameraWatch&) = delete;
  UsbCameraWatch&
  operator=(const UsbCameraWatch&) = delete;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl
