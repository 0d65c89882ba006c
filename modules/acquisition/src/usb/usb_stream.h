#pragma once

#include "usb_stream_endpoint.h"

#include <pcl/acquisition/iidc_bus.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

struct libusb_context;
struct libusb_device_handle;

namespace pcl::acmap {

/** \brief Frames of a camera, each a bulk transfer. All transfers are in flight but those
 * whose frame waits to be taken, so that memory and order of frames are given from the
 * beginning on. It has no thread: events are handled while somebody waits for a frame. */
class UsbStream {
public:
  /** \param[in] context, handle outlive this
   * \throws CameraException Failed when a frame cannot be so long */
  UsbStream(libusb_context& context,
            libusb_device_handle& handle,
            const UsbStreamEndpoint& endpoint,
            std::string place,
            std::size_t frame_bytes);

  /** \brief Gets all transfers back, also when the camera is gone. */
  ~UsbStream();

  UsbStream(const UsbStream&) = delete;
  UsbStream&
  operator=(const UsbStream&) = delete;

  /** \param[in] frames transfers; fewer, 2 at least, where the system has no memory
   * \throws CameraException Unplugged, Failed */
  void
  start(std::size_t frames);

  /** \brief Gives a frame that has come; clears a stall on the way.
   * \param[in,out] frame as in \ref IidcBus::nextFrame; untouched without one
   * \return whether one has
   * \throws CameraException Unplugged, Failed */
  bool
  take(IidcFrame& frame);

  /** \brief Lets libusb work until something happens or time is over.
   * \throws CameraException Failed */
  void
  handleEvents(std::chrono::microseconds time);

private:
  struct Ended;
  struct Slot;
  using Clock = std::chrono::steady_clock;

  Slot*
  nextEnded();

  bool
  isInFlight() const;

  bool
  submit(Slot& slot);

  bool
  takeFrame(Slot& slot, IidcFrame& frame);

  [[noreturn]] void
  lose();

  void
  halt(bool is_stall);

  void
  restart();

  void
  recall() noexcept;

  libusb_context& context_;
  libusb_device_handle& handle_;
  const UsbStreamEndpoint endpoint_;
  const std::string place_;
  const std::size_t frame_bytes_;
  std::size_t buffer_bytes_ = 0;

  std::vector<std::unique_ptr<Slot>> slots_;
  std::shared_ptr<Ended> ended_;
  bool was_full_ = false;  // the last transfer ended without a short packet
  int faults_ = 0;         // in a row
  bool is_gone_ = false;   // the camera; what is in flight comes back
  bool is_halted_ = false; // nothing is in flight until restart_at_
  Clock::time_point restart_at_;
};

} // namespace pcl::acmap
