#pragma once

#include <cstdint>
#include <mutex>
#include <string>

struct libusb_device_handle;

namespace pcl::acmap {

/** \brief Access to registers of a camera by vendor requests of endpoint 0, one quadlet
 * each. Point Grey's cameras tunnel IIDC in this manner. May be used from any
 * thread. */
class UsbRegisters {
public:
  /** \param[in] handle must outlive this object
   * \param[in] place location of the camera, for messages */
  UsbRegisters(libusb_device_handle& handle, std::string place);

  /** \throws CameraException as \ref IidcBus::readQuadlet */
  std::uint32_t
  read(std::uint64_t address);

  /** \throws CameraException as \ref IidcBus::writeQuadlet */
  void
  write(std::uint64_t address, std::uint32_t value);

private:
  /** \brief Repeats a request a few times until the camera answers. */
  void
  transfer(std::uint8_t direction, std::uint64_t address, std::uint8_t* quadlet);

  libusb_device_handle& handle_;
  const std::string place_;
  std::mutex mutex_; // a camera processes one request at a time
};

} // namespace pcl::acmap
