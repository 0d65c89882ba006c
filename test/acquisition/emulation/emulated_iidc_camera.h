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

/** \brief A finished exposure. */
struct Exposure {
  using Time = std::chrono::steady_clock::time_point;

  std::uint64_t number = 0; ///< number of the frame since power-on, including lost ones
  Time begin;
  Time end;
  VideoSetting setting; ///< requested image
};

/** \brief Returns the bytes of the image (image_bytes of them) at the end of its
 * exposure; called from a thread of the camera, one call at a time. */
using FrameSource = std::function<std::vector<std::uint8_t>(const Exposure&)>;

/** \brief Data of one frame in the camera's stream. */
struct CameraFrame {
  std::uint64_t number = 0;
  std::uint64_t stream = 0; ///< its stream, see EmulatedIidcCamera::stream
  std::vector<std::uint8_t> bytes;
  FrameFault fault = FrameFault::None;
};

struct CameraOptions {
  CameraIdentity identity;
  std::string tiles = "YYYY";      ///< of the colour filter
  bool locked = true;              ///< Point Grey's registers require a key
  bool refuse_unknown = false;     ///< reads of unknown registers fail; else all bits
                                   ///< are 1
  std::size_t buffered_frames = 3; ///< further frames are lost
  std::uint32_t setting_reads = 2; ///< reads until a Format_7 setting is valid
};

/** \brief An IIDC 1.30 camera without its bus: registers, and frames in real time.
 *
 * If the buffer is full, new frames are lost, but still counted. All functions may be
 * called from any thread. */
class EmulatedIidcCamera {
public:
  explicit EmulatedIidcCamera(FrameSource source, const CameraOptions& options = {});
  ~EmulatedIidcCamera();

  EmulatedIidcCamera(const EmulatedIidcCamera&) = delete;
  EmulatedIidcCamera&
  operator=(const EmulatedIidcCamera&) = delete;

  /** \brief The quadlet at a bus address; nothing if the camera refuses the read. */
  std::optional<std::uint32_t>
  read(std::uint64_t address);

  /** \brief Returns true if the camera accepts the write, even if it ignores it. */
  bool
  write(std::uint64_t address, std::uint32_t value);

  /** \brief Removes the oldest buffered frame. */
  std::optional<CameraFrame>
  takeFrame();

  /** \brief A number that changes with each start and stop; frames that have not been
   * sent by then are discarded. */
  std::uint64_t
  stream();

  /** \brief Sets a function that is called from a thread of the camera when a frame is
   * available. The listener must not set another one. */
  void
  whenFrameWaits(std::function<void()> listener);

  /** \brief Switches power off and on: resets registers and frame number. */
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

  std::mutex mutex_; ///< protects all following members
  std::condition_variable changed_;
  std::unique_ptr<Registers> registers_;
  std::deque<CameraFrame> waiting_;
  std::uint64_t frames_ = 0;
  std::uint64_t epoch_ = 0; ///< changes with every event that invalidates an exposure
  bool streaming_ = false;
  bool shot_wanted_ = false;
  Time next_end_;
  bool ends_ = false;
  std::thread thread_;
};

} // namespace pcl::acmap::test
