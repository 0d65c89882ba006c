#include "usb_registers.h"

#include "session/little_endian.h"
#include "usb_device.h"

#include <libusb.h>

#include <array>
#include <chrono>
#include <sstream>
#include <thread>

namespace pcl::acmap {

namespace {

constexpr int attempts = 3;
constexpr unsigned timeout_milliseconds = 1000;
// A hub needs this time to notice that a device was removed; until then requests fail.
constexpr std::chrono::milliseconds pause_after_failure(100);

constexpr std::uint8_t reading =
    LIBUSB_ENDPOINT_IN | LIBUSB_REQUEST_TYPE_VENDOR | LIBUSB_RECIPIENT_DEVICE;
constexpr std::uint8_t writing =
    LIBUSB_ENDPOINT_OUT | LIBUSB_REQUEST_TYPE_VENDOR | LIBUSB_RECIPIENT_DEVICE;

using Quadlet = std::array<std::uint8_t, 4>;

/** \brief The request code for a part of the address space; 0: there is none. */
std::uint8_t
requestFor(std::uint64_t address)
{
  switch (address >> 32) {
  case 0xFFFF:
    return 0x7F;
  case 0xD000:
    return 0x80;
  case 0xD001:
    return 0x81;
  default:
    return 0;
  }
}

std::string
textOf(std::uint8_t direction, std::uint64_t address)
{
  std::ostringstream text;
  text << (direction == reading ? "reading register " : "writing register ") << std::hex
       << address;
  return text.str();
}

bool
isWorthRetrying(int error)
{
  return error == LIBUSB_ERROR_TIMEOUT || error == LIBUSB_ERROR_IO ||
         error == LIBUSB_ERROR_OVERFLOW || error == LIBUSB_ERROR_INTERRUPTED;
}

} // namespace

UsbRegisters::UsbRegisters(libusb_device_handle& handle, std::string place)
: handle_(handle)
, place_(std::move(place))
{}

std::uint32_t
UsbRegisters::read(std::uint64_t address)
{
  Quadlet bytes{};
  transfer(reading, address, bytes.data());
  const std::uint8_t* data = bytes.data();
  return takeNumber<std::uint32_t>(data);
}

void
UsbRegisters::write(std::uint64_t address, std::uint32_t value)
{
  Quadlet bytes{};
  std::uint8_t* data = bytes.data();
  putNumber(data, value);
  transfer(writing, address, bytes.data());
}

void
UsbRegisters::transfer(std::uint8_t direction,
                       std::uint64_t address,
                       std::uint8_t* quadlet)
{
  const std::uint8_t request = requestFor(address);
  if (request == 0 || address % sizeof(Quadlet) != 0)
    failUsb(LIBUSB_ERROR_PIPE, place_, textOf(direction, address));

  const std::lock_guard lock(mutex_);
  for (int attempt = 1;; ++attempt) {
    int result = libusb_control_transfer(&handle_,
                                         direction,
                                         request,
                                         address & 0xFFFF,
                                         address >> 16 & 0xFFFF,
                                         quadlet,
                                         sizeof(Quadlet),
                                         timeout_milliseconds);
    if (result == static_cast<int>(sizeof(Quadlet)))
      return;
    if (result >= 0)
      result = LIBUSB_ERROR_IO; // an incomplete quadlet
    if (attempt == attempts || !isWorthRetrying(result))
      failUsb(result, place_, textOf(direction, address));
    if (result == LIBUSB_ERROR_IO)
      std::this_thread::sleep_for(pause_after_failure);
  }
}

} // namespace pcl::acmap
