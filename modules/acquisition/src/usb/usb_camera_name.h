#pragma once

#include <pcl/acquisition/usb_camera.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace pcl::acmap {

/** \brief Which camera somebody wants; at most one of the three is set. */
struct UsbCameraName {
  std::string serial;                                          ///< in lower case
  std::string place;                                           ///< as in \ref UsbCamera
  std::optional<std::pair<std::uint16_t, std::uint16_t>> kind; ///< vendor, product

  /** \brief Whether it can be this one, as far as is known without opening it. */
  bool
  fits(const UsbCamera& camera) const;
};

/** \param[in] text as \ref openUsbBus takes it
 * \throws BadArgumentException */
UsbCameraName
parseUsbCameraName(const std::string& text);

} // namespace pcl::acmap
