#pragma once

#include <pcl/acquisition/usb_camera.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace pcl::acmap {

/** \brief Parsed name of a camera; at most one of the three members is set. */
struct UsbCameraName {
  std::string serial;                                          ///< in lower case
  std::string place;                                           ///< as in \ref UsbCamera
  std::optional<std::pair<std::uint16_t, std::uint16_t>> kind; ///< vendor, product

  /** \brief Returns true if a camera can be the named one, as far as known without
   * opening it. */
  bool
  fits(const UsbCamera& camera) const;
};

/** \param[in] text as in \ref openUsbBus
 * \throws BadArgumentException if the text is not a valid name */
UsbCameraName
parseUsbCameraName(const std::string& text);

} // namespace pcl::acmap
