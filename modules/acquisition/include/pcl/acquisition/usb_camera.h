#pragma once

#include <pcl/acquisition/iidc_bus.h>
#include <pcl/core/export.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pcl {

/** \brief An IIDC camera on the USB, as an entry of a list. \ingroup acquisition */
struct UsbCamera {
  std::string
      place; ///< `BUS:ADDRESS` in decimal, e.g. `1:4`; changes when it is replugged
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string speed; ///< for example `480 Mb/s`; empty if the system does not report it
  std::string
      serial; ///< 16 hexadecimal digits, the camera's GUID; empty when not opened
  std::string maker; ///< as reported by the camera; empty when not opened
  std::string model; ///< as reported by the camera; empty when not opened

  /** \brief Why it could not be opened; CameraFault::None if it could. */
  CameraFault fault = CameraFault::None;
  std::string message; ///< message of the fault
};

/** \brief Lists the cameras: devices of Point Grey (vendor 1e10), the only ones known
 * to tunnel IIDC through USB. Each is opened briefly to read its identity.
 * \throws CameraException Failed when USB is not available
 * \ingroup acquisition */
ACMAP_EXPORT std::vector<UsbCamera>
listUsbCameras();

/** \brief Opens a USB camera.
 *
 * The Digiclops itself is an IEEE-1394 camera. This function uses IIDC tunnelled over
 * USB: registers by vendor requests of endpoint 0, frames by bulk transfers of one
 * frame each.
 * \param[in] device serial number as in \ref UsbCamera; or `BUS:ADDRESS`; or
 * `usb:VENDOR:PRODUCT` in hexadecimal for a bridge of another maker; empty: the first
 * camera that can be opened
 * \throws BadArgumentException when device is none of these
 * \throws CameraException NotFound, PermissionDenied (the message names the udev rule),
 * Busy, Malformed when its descriptors contain no stream, Silent when it does not
 * report its identity, Failed
 * \ingroup acquisition */
ACMAP_EXPORT std::unique_ptr<IidcBus>
openUsbBus(const std::string& device = {});

/** \brief Reports cameras that are connected or removed, during its lifetime.
 * \ingroup acquisition */
class ACMAP_EXPORT UsbCameraWatch {
public:
  /** \brief Called in a thread of the watch; must not destroy the watch. Exceptions are
   * ignored.
   * \param[in] camera its place, vendor and product; it was not opened
   * \param[in] is_there false: the camera was removed */
  using Callback = std::function<void(const UsbCamera& camera, bool is_there)>;

  /** \brief Starts the watch; cameras that are already connected are reported first.
   * \throws CameraException Failed if the system cannot report changes */
  explicit UsbCameraWatch(Callback callback);

  /** \brief Stops the watch; no callback is called after the return. */
  ~UsbCameraWatch();

  UsbCameraWatch(const UsbCameraWatch&) = delete;
  UsbCameraWatch&
  operator=(const UsbCameraWatch&) = delete;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl
