#pragma once

#include "camera_faults.h"
#include "config_rom.h"
#include "feature_registers.h"
#include "register_map.h"
#include "vendor_registers.h"
#include "video_registers.h"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace pcl::acmap::test {

/** \brief An exposure that has just ended. */
struct Exposure {
  using Time = std::chrono::steady_clock::time_point;

  std::uint64_t number = 0; ///< of the frame since power came; lost ones count
  Time begin;
  Time end;
  VideoSetting setting; ///< the image wanted
};

/** \brief Gives the bytes of the image (image_bytes of them) at the end of its exposure;
 * called from a thread of the camera, one call at a time. */
using FrameSource = std::function<std::vector<std::uint8_t>(const Exposure&)>;

/** \brief What the camera sends over its stream for one frame. */
struct CameraFrame {
  std::uint64_t number = 0;
  std::uint64_t stream = 0; ///< that it belongs to, see EmulatedIidcCamera::stream
  std::vector<std::uint8_t> bytes;
  FrameFault fault = FrameFault::None;
};

struct CameraOptions {
  CameraIdentity identity;
  std::string tiles = "YYYY";      ///< of the colour filter
  bool locked = true;              ///< Point Grey's registers ask for their key
  bool refuse_unknown = false;     ///< a read of no register fails; else all bits are 1
  std::size_t buffered_frames = 3; ///< a further one is lost
  std::uint32_t setting_reads = 2; ///< polls until Format_7 has settled
};

/** \brief An IIDC 1.30 camera without its bus: registers, and frames in real time.
 *
 * A frame that nobody takes before the buffer is full is lost, and its number with it.
 * All functions may be called from any thread. */
class EmulatedIidcCamera {
public:
  explicit EmulatedIidcCamera(FrameSource source, const CameraOptions& options = {});
  ~EmulatedIidcCamera();

  EmulatedIidcCamera(const EmulatedIidcCamera&) = delete;
  EmulatedIidcCamera&
  operator=(const EmulatedIidcCamera&) = delete;

  /** \brief The quadlet at an address of the bus; none: the camera refuses. */
  std::optional<std::uint32_t>
  read(std::uint64_t address);

  /** \brief Whether the camera accepts the write, even if it ignores it. */
  bool
  write(std::uint64_t address, std::uint32_t value);

  /** \brief The oldest frame that waits. */
  std::optional<CameraFrame>
  takeFrame();

  /** \brief Another number after each start and stop: what was not sent till then never
   * will be. */
  std::uint64_t
  stream();

  /** \brief Called, from a thread of the camera, when a frame waits. The listener must not
   * set another one. */
  void
  whenFrameWaits(std::function<void()> listener);

  /** \brief Power goes and comes: registers as at first, frames count from 0. */
  void
  cyclePower();

  CameraFaults&
  faults()
  {
    return faults_;
  }

private:
  using Time = Exposure::Time;
  struct Registers;

  void
  written(std::uint32_t offset, std::uint32_t value);
  void
  start();
  void
  stop();
  void
  requestShot();
  void
  run();
  bool
  waitForExposure(std::unique_lock<std::mutex>& lock);
  void
  expose(std::unique_lock<std::mutex>& lock);
  std::chrono::duration<double>
  period() const;

  const FrameSource source_;
  const CameraOptions options_;
  const std::vector<std::uint32_t> rom_;
  CameraFaults faults_;

  std::mutex listener_mutex_;
  std::function<void()> listener_;

  std::mutex mutex_; ///< of all that follows
  std::condition_variable changed_;
  std::unique_ptr<Registers> registers_;
  std::deque<CameraFrame> waiting_;
  std::uint64_t frames_ = 0;
  std::uint64_t epoch_ = 0; ///< changes with all that makes an exposure void
  bool streaming_ = false;
  bool shot_wanted_ = false;
  Time next_end_;
  bool ends_ = false;
  std::thread thread_;
};

} // namespace pcl::acmap::test
