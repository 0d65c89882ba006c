#pragma once

#include "usb_device.h"
#include "usb_registers.h"
#include "usb_stream.h"

#include <atomic>

namespace pcl::acmap {

/** \brief Claims an interface of a device for exclusive use, during its lifetime. */
class UsbClaim {
public:
  /** \param[in] handle must outlive this object
   * \throws CameraException Busy, Unplugged, Failed */
  UsbClaim(libusb_device_handle& handle,
           const UsbStreamEndpoint& endpoint,
           const std::string& place);

  ~UsbClaim();

  UsbClaim(const UsbClaim&) = delete;
  UsbClaim&
  operator=(const UsbClaim&) = delete;

private:
  libusb_device_handle& handle_;
  const int interface_;
};

/** \brief The bus of a USB camera. */
class UsbIidcBus : public IidcBus {
public:
  /** \brief Claims the camera.
   * \throws CameraException Busy, Malformed, Unplugged, Failed */
  UsbIidcBus(UsbContext context, UsbHandle handle, std::string place);

  ~UsbIidcBus() override;

  std::string
  place() const override;

  std::uint32_t
  readQuadlet(std::uint64_t address) override;

  void
  writeQuadlet(std::uint64_t address, std::uint32_t value) override;

  void
  startStream(std::size_t frame_bytes, std::size_t frames) override;

  IidcWait
  nextFrame(IidcFrame& frame, std::chrono::milliseconds timeout) override;

  void
  stopStream() noexcept override;

  void
  cancel() noexcept override;

private:
  // In the order of their dependencies.
  const UsbContext context_;
  const UsbHandle handle_;
  const std::string place_;
  const UsbStreamEndpoint endpoint_;
  const UsbClaim claim_;
  UsbRegisters registers_;
  std::unique_ptr<UsbStream> stream_;

  // Set until nextFrame has reported it, or another stream begins.
  std::atomic<bool> is_cancelled_{false};
};

} // namespace pcl::acmap
