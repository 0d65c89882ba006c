#include "usb_stream_endpoint.h"

#include "usb_device.h"

#include <optional>

namespace pcl::acmap {

namespace {

constexpr std::uint8_t usual_address = 0x81;
constexpr std::size_t largest_packet = 1024; // maximum of USB 3

using UsbConfiguration = std::unique_ptr<libusb_config_descriptor,
                                         UsbRelease<libusb_free_config_descriptor>>;

/** \brief The active configuration, or the first one if none is active. */
UsbConfiguration
configurationOf(libusb_device& device, const std::string& place)
{
  libusb_config_descriptor* found = nullptr;
  int result = libusb_get_active_config_descriptor(&device, &found);
  if (result == LIBUSB_ERROR_NOT_FOUND)
    result = libusb_get_config_descriptor(&device, 0, &found);
  if (result == LIBUSB_ERROR_NOT_FOUND || result == LIBUSB_ERROR_IO)
    throw CameraException(CameraFault::Malformed,
                          place + ": its descriptors cannot be understood");
  checkUsb(result, place, "reading descriptors");
  return UsbConfiguration(found);
}

bool
sendsInBulk(const libusb_endpoint_descriptor& endpoint)
{
  return (endpoint.bEndpointAddress & LIBUSB_ENDPOINT_DIR_MASK) == LIBUSB_ENDPOINT_IN &&
         (endpoint.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) ==
             LIBUSB_ENDPOINT_TRANSFER_TYPE_BULK;
}

} // namespace

UsbStreamEndpoint
findUsbStreamEndpoint(libusb_device& device, const std::string& place)
{
  return streamEndpointIn(*configurationOf(device, place), place);
}

UsbStreamEndpoint
streamEndpointIn(const libusb_config_descriptor& configuration,
                 const std::string& place)
{
  std::optional<UsbStreamEndpoint> found;
  for (int i = 0; i < configuration.bNumInterfaces; ++i)
    for (int k = 0; k < configuration.interface[i].num_altsetting; ++k) {
      const libusb_interface_descriptor& setting =
          configuration.interface[i].altsetting[k];
      // For truncated descriptors, libusb reports the number of endpoints, but no
      // endpoints.
      const int endpoints = setting.endpoint ? setting.bNumEndpoints : 0;
      for (int n = 0; n < endpoints; ++n) {
        const libusb_endpoint_descriptor& endpoint = setting.endpoint[n];
        const bool is_better = !found || (found->address != usual_address &&
                                          endpoint.bEndpointAddress == usual_address);
        if (sendsInBulk(endpoint) && is_better)
          found = UsbStreamEndpoint{configuration.bConfigurationValue,
                                    setting.bInterfaceNumber,
                                    setting.bAlternateSetting,
                                    endpoint.bEndpointAddress,
                                    endpoint.wMaxPacketSize};
      }
    }
  if (!found)
    throw CameraException(CameraFault::Malformed,
                          place + ": its descriptors have no stream");
  if (found->packet_bytes == 0 || found->packet_bytes > largest_packet)
    throw CameraException(CameraFault::Malformed,
                          place + ": packets of " +
                              std::to_string(found->packet_bytes) + " bytes cannot be");
  return *found;
}

} // namespace pcl::acmap
