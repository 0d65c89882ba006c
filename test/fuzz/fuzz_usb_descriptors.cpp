#include "checks.h"
#include "usb/usb_stream_endpoint.h"

#include <pcl/core/camera_exception.h>

#include <libusb.h>

#include <vector>

using namespace pcl::acmap;

namespace {

constexpr int max_parts = 4; // maximum number of children per node

/** \brief A configuration as returned by libusb: the number of endpoints can be larger
 * than the array, which is then missing. */
class Configuration {
public:
  explicit Configuration(test::FuzzedBytes numbers)
  {
    descriptor_.bConfigurationValue = numbers.byte();
    const std::size_t interfaces = numbers.byte() % (max_parts + 1);
    settings_.resize(interfaces);
    endpoints_.resize(interfaces * max_parts);
    for (std::size_t i = 0; i < interfaces; ++i)
      interfaces_.push_back(interfaceOf(i, numbers));
    descriptor_.bNumInterfaces = static_cast<std::uint8_t>(interfaces);
    descriptor_.interface = interfaces_.data();
  }

  const libusb_config_descriptor&
  descriptor() const
  {
    return descriptor_;
  }

private:
  libusb_interface
  interfaceOf(std::size_t number, test::FuzzedBytes& numbers)
  {
    std::vector<libusb_interface_descriptor>& settings = settings_[number];
    settings.resize(numbers.byte() % (max_parts + 1));
    for (std::size_t k = 0; k < settings.size(); ++k) {
      settings[k] = {};
      settings[k].bInterfaceNumber = numbers.byte();
      settings[k].bAlternateSetting = numbers.byte();
      settings[k].bNumEndpoints = numbers.byte();
      fill(endpoints_[number * max_parts + k], settings[k], numbers);
    }
    return {settings.data(), static_cast<int>(settings.size())};
  }

  static void
  fill(std::vector<libusb_endpoint_descriptor>& endpoints,
       libusb_interface_descriptor& setting,
       test::FuzzedBytes& numbers)
  {
    if (setting.bNumEndpoints > max_parts)
      return;
    endpoints.resize(setting.bNumEndpoints);
    for (libusb_endpoint_descriptor& endpoint : endpoints) {
      endpoint = {};
      endpoint.bEndpointAddress = numbers.byte();
      endpoint.bmAttributes = numbers.byte();
      endpoint.wMaxPacketSize = numbers.number<std::uint16_t>();
    }
    setting.endpoint = endpoints.data();
  }

  libusb_config_descriptor descriptor_{};
  std::vector<libusb_interface> interfaces_;
  std::vector<std::vector<libusb_interface_descriptor>> settings_;
  std::vector<std::vector<libusb_endpoint_descriptor>> endpoints_;
};

} // namespace

/** Descriptors are rejected, or name an endpoint with a valid packet size. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const Configuration configuration(test::FuzzedBytes(data, size));
  try {
    const UsbStreamEndpoint found =
        streamEndpointIn(configuration.descriptor(), "fuzzed");
    test::require((found.address & 0x80) != 0);
    test::require(found.packet_bytes > 0 && found.packet_bytes <= 1024);
  }
  catch (const pcl::CameraException& refusal) {
    test::require(refusal.fault() == pcl::CameraFault::Malformed);
  }
  return 0;
}
