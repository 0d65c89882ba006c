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

/** \brief Receives the frames of a camera, one bulk transfer per frame. All transfers
 * are in flight except those whose frame waits to be taken. Therefore all memory is
 * allocated at the start, and the order of frames is fixed. There is no thread: events
 * are handled while a caller waits for a frame. */
class UsbStream {
public:
  /** \param[in] context must outlive this object
   * \param[in] handle must outlive this object
   * \param[in] endpoint of the stream
   * \param[in] place location of the camera, for messages
   * \param[in] frame_bytes length of a complete frame
   * \throws CameraException Failed for an invalid frame length */
  UsbStream(libusb_context& context,
            libusb_device_handle& handle,
            const UsbStreamEndpoint& endpoint,
            std::string place,
            std::size_t frame_bytes);

  /** \brief Cancels all transfers, also when the camera was removed. */
  ~UsbStream();

  UsbStream(const UsbStream&) = delete;
  UsbStream&
  operator=(const UsbStream&) = delete;

  /** \brief Submits the transfers.
   * \param[in] frames number of transfers; it is reduced, to 2 at least, when the
   * system is short of memory
   * \throws CameraException Unplugged, Failed */
  void
  start(std::size_t frames);

  /** \brief Takes a frame that has arrived; clears a stalled endpoint.
   * \param[in,out] frame as in \ref IidcBus::nextFrame; unchanged if there is no frame
   * \return true if there was a frame
   * \throws CameraException Unplugged, Failed */
  bool
  take(IidcFrame& frame);

  /** \brief Lets libusb handle events until one occurs or the time has passed.
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
  int faults_ = 0;         // consecutive faults
  bool is_gone_ = false;   // the camera was removed; pending transfers end
  bool is_halted_ = false; // no transfers until restart_at_
  Clock::time_point restart_at_;
};

} // namespace pcl::acmap
