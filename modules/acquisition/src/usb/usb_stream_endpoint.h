#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

struct libusb_config_descriptor;
struct libusb_device;

namespace pcl::acmap {

/** \brief The endpoint that transmits a camera's frames. */
struct UsbStreamEndpoint {
  int configuration = 0;
  int interface = 0;
  int alternate = 0; ///< alternate setting of the interface
  std::uint8_t address = 0;
  std::size_t packet_bytes = 0; ///< size of packets, except for the last one of a frame
};

/** \brief Searches the descriptors for bulk endpoint 0x81, which Point Grey's cameras
 * use, or otherwise for the first bulk endpoint that sends.
 * \throws CameraException Malformed when there is none, or it is invalid */
UsbStreamEndpoint
findUsbStreamEndpoint(libusb_device& device, const std::string& place);

/** \brief The same in one configuration. */
UsbStreamEndpoint
streamEndpointIn(const libusb_config_descriptor& configuration,
                 const std::string& place);

} // namespace pcl::acmap
