#pragma once

#include <pcl/acquisition/camera_exception.h>
#include <pcl/core/export.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pcl {

/** \brief A frame as it came over a bus. \ingroup acquisition */
struct IidcFrame {
  std::vector<std::uint8_t> bytes; ///< all that came
  bool is_whole = false;           ///< as many bytes as the stream has a frame of
  std::uint64_t stamp = 0;         ///< microseconds since 1970, when its last byte came
};

/** \brief How waiting for a frame ended. \ingroup acquisition */
enum class IidcWait {
  Frame,    ///< with a frame, whole or not
  TimedOut, ///< without
  Cancelled ///< without: \ref IidcBus::cancel was called
};

/** \brief One camera on a bus: its registers and its stream, whatever carries them. What
 * the bytes mean is \ref IidcCamera's to know. Implement it to connect a camera by other
 * means than \ref openUsbBus.
 *
 * An address is one of the camera's 48 bit address space, a multiple of 4; its registers
 * begin at 0xFFFFF0000000.
 *
 * \ref readQuadlet, \ref writeQuadlet and \ref cancel may be called from any thread at any
 * time, the others from one thread at a time. Nothing waits for ever. The camera, and all
 * that was reserved for it, is given back by the destructor. \ingroup acquisition */
class ACMAP_EXPORT IidcBus {
public:
  virtual ~IidcBus();

  IidcBus(const IidcBus&) = delete;
  IidcBus&
  operator=(const IidcBus&) = delete;

  /** \brief Where the camera is, for messages: say `usb 1:4`. */
  virtual std::string
  place() const = 0;

  /** \throws CameraException Unplugged; Silent without an answer after the retries;
   * Unsupported when the camera has nothing at this address; Failed */
  virtual std::uint32_t
  readQuadlet(std::uint64_t address) = 0;

  /** \throws CameraException likewise */
  virtual void
  writeQuadlet(std::uint64_t address, std::uint32_t value) = 0;

  /** \brief Gets ready for frames, before the camera is told to send them. What came
   * before is forgotten.
   * \param[in] frame_bytes length of a whole frame
   * \param[in] frames how many may wait for \ref nextFrame; fewer where memory of the
   * system is short
   * \throws CameraException Unplugged; Failed, also when a stream is there already */
  virtual void
  startStream(std::size_t frame_bytes, std::size_t frames) = 0;

  /** \brief Waits for the next frame, in the order in which they come; a stalled stream is
   * cleared and goes on.
   * \param[in,out] frame its memory is taken over for further frames
   * \throws CameraException Unplugged; Failed, also without a stream */
  virtual IidcWait
  nextFrame(IidcFrame& frame, std::chrono::milliseconds timeout) = 0;

  /** \brief Gives back what \ref startStream took; nothing without a stream. Does not
   * throw when the camera is gone. */
  virtual void
  stopStream() noexcept = 0;

  /** \brief Ends the wait in \ref nextFrame, or the next one, within a few milliseconds;
   * once, and not in a stream that is started later. */
  virtual void
  cancel() noexcept = 0;

protected:
  IidcBus() = default;
};

/** \brief Opens a bus to one camera, each time it is called: again after the camera was
 * gone. \ingroup acquisition */
using IidcBusOpener = std::function<std::unique_ptr<IidcBus>()>;

} // namespace pcl
