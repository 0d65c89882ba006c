#pragma once

#include <pcl/core/camera_exception.h>
#include <pcl/core/export.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pcl {

/** \brief A frame as it was received from a bus. \ingroup acquisition */
struct IidcFrame {
  std::vector<std::uint8_t> bytes; ///< all bytes that were received
  bool is_whole = false;   ///< true if it has the length of a frame of the stream
  std::uint64_t stamp = 0; ///< microseconds since 1970, when its last byte arrived
};

/** \brief Result of waiting for a frame. \ingroup acquisition */
enum class IidcWait {
  Frame,    ///< a frame arrived, complete or not
  TimedOut, ///< no frame arrived in time
  Cancelled ///< no frame: \ref IidcBus::cancel was called
};

/** \brief Interface to one camera on a bus: its registers and its stream, independent
 * of the transport. \ref IidcCamera interprets the data. Implement this interface to
 * connect a camera by other means than \ref openUsbBus.
 *
 * Addresses are those of the camera's 48 bit address space and multiples of 4; its
 * registers begin at 0xFFFFF0000000.
 *
 * \ref readQuadlet, \ref writeQuadlet and \ref cancel may be called from any thread at
 * any time, the others from one thread at a time. No function blocks without a time
 * limit. The destructor releases the camera and everything that was reserved for it.
 * \ingroup acquisition */
class ACMAP_EXPORT IidcBus {
public:
  virtual ~IidcBus();

  IidcBus(const IidcBus&) = delete;
  IidcBus&
  operator=(const IidcBus&) = delete;

  /** \brief Location of the camera for messages, for example `usb 1:4`. */
  virtual std::string
  place() const = 0;

  /** \throws CameraException Unplugged; Silent if there is no answer after the retries;
   * Unsupported when the camera has no register at this address; Failed */
  virtual std::uint32_t
  readQuadlet(std::uint64_t address) = 0;

  /** \throws CameraException as \ref readQuadlet */
  virtual void
  writeQuadlet(std::uint64_t address, std::uint32_t value) = 0;

  /** \brief Prepares for receiving frames; to be called before the camera is told to
   * send them. Frames that were received earlier are discarded.
   * \param[in] frame_bytes length of a complete frame
   * \param[in] frames maximum number of frames that wait for \ref nextFrame; it is
   * reduced when the system is short of memory
   * \throws CameraException Unplugged; Failed, also when a stream is already active */
  virtual void
  startStream(std::size_t frame_bytes, std::size_t frames) = 0;

  /** \brief Waits for the next frame, in the order of arrival. A stalled stream is
   * cleared and continues.
   * \param[in,out] frame its memory is reused for further frames
   * \throws CameraException Unplugged; Failed, also without a stream */
  virtual IidcWait
  nextFrame(IidcFrame& frame, std::chrono::milliseconds timeout) = 0;

  /** \brief Releases what \ref startStream reserved; does nothing without a stream.
   * Does not throw when the camera was removed. */
  virtual void
  stopStream() noexcept = 0;

  /** \brief Ends the current or the next wait in \ref nextFrame within a few
   * milliseconds. It acts on one wait, and not on a stream that is started later. */
  virtual void
  cancel() noexcept = 0;

protected:
  IidcBus() = default;
};

/** \brief Opens a bus to one camera. It is called again to reopen the camera after it
 * was removed. \ingroup acquisition */
using IidcBusOpener = std::function<std::unique_ptr<IidcBus>()>;

} // namespace pcl
