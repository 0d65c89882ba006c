#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Properties of a USB device. */
struct UsbIdentity {
  std::uint16_t vendor = 0x1E10; ///< Point Grey
  std::uint16_t product = 0x2000;
  std::string manufacturer = "Point Grey Research";
  std::string name = "Emulated Digiclops";
  std::string serial = "00B09D0100C0FFEE";
  bool bulk_endpoint = true;
  bool super_speed = false;
  bool splits_bulk = false; ///< the system splits transfers into pieces of 16 KiB, as
                            ///< old ones do
  std::size_t memory = std::size_t{16} << 20; ///< available to the system for transfers
  std::vector<std::uint8_t> descriptors;      ///< replace the computed ones unless
                                              ///< empty
};

/** \brief Descriptors of device, configuration, interface and, if there is one,
 * endpoint 0x81. */
std::vector<std::uint8_t>
descriptorsOf(const UsbIdentity& identity);

/** \brief String descriptor by number: 0 languages, 1 manufacturer, 2 product, 3 serial
 * number; empty for others. */
std::vector<std::uint8_t>
stringDescriptor(const UsbIdentity& identity, unsigned number);

} // namespace pcl::acmap::test
