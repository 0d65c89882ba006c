#include "usb_client.h"

#include <array>
#include <stdexcept>

namespace pcl::acmap::test {
namespace {

constexpr std::uint8_t request = 0x7F;

} // namespace

UsbClient::UsbClient()
{
  if (libusb_init(&context_) != 0)
    throw std::runtime_error("libusb does not start");
}

UsbClient::~UsbClient()
{
  close();
  libusb_exit(context_);
}

std::size_t
UsbClient::count()
{
  libusb_device** devices = nullptr;
  const auto found = libusb_get_device_list(context_, &devices);
  libusb_free_device_list(devices, 1);
  return static_cast<std::size_t>(found);
}

int
UsbClient::open(std::size_t place)
{
  libusb_device** devices = nullptr;
  const auto found = libusb_get_device_list(context_, &devices);
  int error = LIBUSB_ERROR_NO_DEVICE;
  if (found > static_cast<ssize_t>(place))
    error = libusb_open(devices[place], &handle_);
  libusb_free_device_list(devices, 1);
  return error ? error : libusb_claim_interface(handle_, 0);
}

void
UsbClient::close()
{
  if (!handle_)
    return;
  // The mock detects a close slightly later than the kernel would.
  libusb_release_interface(handle_, 0);
  libusb_close(handle_);
  handle_ = nullptr;
}

int
UsbClient::read(std::uint32_t offset, std::uint32_t& value)
{
  std::array<std::uint8_t, 4> data{};
  const auto address = static_cast<std::uint32_t>(iidc::commands) + offset;
  const int count = libusb_control_transfer(handle_,
                                            0xC0,
                                            request,
                                            static_cast<std::uint16_t>(address),
                                            static_cast<std::uint16_t>(address >> 16),
                                            data.data(),
                                            4,
                                            patience_ms);
  value = data[0] | data[1] << 8 | data[2] << 16 |
          static_cast<std::uint32_t>(data[3]) << 24;
  return count;
}

int
UsbClient::write(std::uint32_t offset, std::uint32_t value)
{
  std::array<std::uint8_t, 4> data{};
  for (std::size_t i = 0; i < 4; ++i)
    data[i] = static_cast<std::uint8_t>(value >> (8 * i));
  const auto address = static_cast<std::uint32_t>(iidc::commands) + offset;
  return libusb_control_transfer(handle_,
                                 0x40,
                                 request,
                                 static_cast<std::uint16_t>(address),
                                 static_cast<std::uint16_t>(address >> 16),
                                 data.data(),
                                 4,
                                 patience_ms);
}

int
UsbClient::receive(std::vector<std::uint8_t>& bytes,
                   std::size_t maximum,
                   unsigned timeout_ms)
{
  bytes.resize(maximum);
  int count = 0;
  const int error = libusb_bulk_transfer(
      handle_, 0x81, bytes.data(), static_cast<int>(maximum), &count, timeout_ms);
  bytes.resize(static_cast<std::size_t>(count));
  return error;
}

} // namespace pcl::acmap::test
