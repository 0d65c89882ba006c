#pragma once

#include "iidc_addresses.h"

#include <libusb.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace pcl::acmap::test {

/** \brief A simple client of libusb, to test the emulation. */
class UsbClient {
public:
  /** \brief Timeout of reads and writes. */
  static constexpr unsigned patience_ms = 300;

  UsbClient();
  ~UsbClient();

  UsbClient(const UsbClient&) = delete;
  UsbClient&
  operator=(const UsbClient&) = delete;

  libusb_context*
  context()
  {
    return context_;
  }

  /** \brief Number of devices. */
  std::size_t
  count();

  /** \brief Opens a device by its index in the list and claims it; returns libusb's
   * error code. */
  int
  open(std::size_t place = 0);

  void
  close();

  libusb_device_handle*
  handle()
  {
    return handle_;
  }

  /** \brief Returns the number of bytes read or an error code; offset relative to the
   * command registers. */
  int
  read(std::uint32_t offset, std::uint32_t& value);

  int
  write(std::uint32_t offset, std::uint32_t value);

  /** \brief Receives one transfer of the stream, of at most this many bytes. */
  int
  receive(std::vector<std::uint8_t>& bytes, std::size_t maximum, unsigned timeout_ms);

private:
  libusb_context* context_ = nullptr;
  libusb_device_handle* handle_ = nullptr;
};

} // namespace pcl::acmap::test
