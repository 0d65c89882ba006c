#pragma once

#include "iidc_addresses.h"

#include <libusb.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace pcl::acmap::test {

/** \brief A plain user of libusb, to look at the emulation with. */
class UsbClient {
public:
  /** \brief Reads or writes give up after this. */
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

  /** \brief How many devices there are. */
  std::size_t
  count();

  /** \brief Opens a device by its place in the list and claims it: error code of libusb. */
  int
  open(std::size_t place = 0);

  void
  close();

  libusb_device_handle*
  handle()
  {
    return handle_;
  }

  /** \brief Bytes read or an error code; offset from the command registers. */
  int
  read(std::uint32_t offset, std::uint32_t& value);

  int
  write(std::uint32_t offset, std::uint32_t value);

  /** \brief One transfer of the stream; of this many bytes at most. */
  int
  receive(std::vector<std::uint8_t>& bytes, std::size_t most, unsigned timeout_ms);

private:
  libusb_context* context_ = nullptr;
  libusb_device_handle* handle_ = nullptr;
};

} // namespace pcl::acmap::test
