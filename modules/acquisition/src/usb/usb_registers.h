#pragma once

#include <cstdint>
#include <mutex>
#include <string>

struct libusb_device_handle;

namespace pcl::acmap {

/** \brief Registers of a camera as vendor requests of endpoint 0, one quadlet each: the
 * way in which Point Grey's cameras tunnel IIDC. From any thread. */
class UsbRegisters {
public:
  /** \param[in] handle outlives this
   * \param[in] place for messages */
  UsbRegisters(libusb_device_handle& handle, std::string place);

  /** \throws CameraException as \ref IidcBus::readQuadlet */
  std::uint32_t
  read(std::uint64_t address);

  /** \throws CameraException as \ref IidcBus::writeQuadlet */
  void
  write(std::uint64_t address, std::uint32_t value);

private:
  /** \brief Tries until the camera answers, a few times. */
  void
  transfer(std::uint8_t direction, std::uint64_t address, std::uint8_t* quadlet);

  libusb_device_handle& handle_;
  const std::string place_;
  std::mutex mutex_; // a camera answers one request after the other
};

} // namespace pcl::acmap
