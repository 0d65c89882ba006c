#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

struct libusb_config_descriptor;
struct libusb_device;

namespace pcl::acmap {

/** \brief Where a camera's frames come from. */
struct UsbStreamEndpoint {
  int configuration = 0;
  int interface = 0;
  int alternate = 0; ///< setting of the interface
  std::uint8_t address = 0;
  std::size_t packet_bytes = 0; ///< of all packets but the last of a frame
};

/** \brief Searches the descriptors for bulk endpoint 0x81, which Point Grey's cameras send
 * on, or else for the first that sends in bulk.
 * \throws CameraException Malformed when there is none, or none that can be */
UsbStreamEndpoint
findUsbStreamEndpoint(libusb_device& device, const std::string& place);

/** \brief The same in one configuration. */
UsbStreamEndpoint
streamEndpointIn(const libusb_config_descriptor& configuration,
                 const std::string& place);

} // namespace pcl::acmap
