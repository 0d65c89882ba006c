#pragma once

#include "frame_count.h"

#include <pcl/acquisition/iidc_camera.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>

namespace pcl::acmap {

/** \brief Statistics of the frames of a camera. */
struct StreamCounts {
  long lost = 0;
  std::size_t broken = 0;
  std::size_t early = 0;
  std::size_t restarts = 0;
};

/** \brief A complete frame. */
struct WholeFrame {
  IidcFrame data;
  std::size_t lost = 0; ///< frames lost before it, according to the counter
};

/** \brief Reads complete frames of a camera and recovers from errors of its stream. All
 * functions except \ref counts must be called from one thread. */
class CameraStream {
public:
  enum class Way {
    Free,  ///< continuous frames
    Single ///< single frames, each exposed after its request
  };

  /** \brief While an object of this class exists, \ref next does not wait and returns
   * false. May be used in any thread. */
  class Interruption {
  public:
    explicit Interruption(CameraStream& stream)
    : stream_(stream)
    {
      ++stream_.interruptions_;
      stream_.camera_.cancel();
    }

    ~Interruption()
    {
      --stream_.interruptions_;
    }

    Interruption(const Interruption&) = delete;
    Interruption&
    operator=(const Interruption&) = delete;

  private:
    CameraStream& stream_;
  };

  explicit CameraStream(IidcCamera& camera)
  : camera_(camera)
  {}

  /** \brief Sets the properties of frames, from the next stream on.
   * \param[in] mode size of the frames
   * \param[in] rate frames per second
   * \param[in] patience time in seconds, in addition to three periods, after which a
   * stream counts as silent */
  void
  setUp(const IidcMode& mode, double rate, double patience);

  /** \brief Starts the stream if necessary, opening the camera if it is closed, and
   * waits for a complete frame.
   * \return false when it was interrupted
   * \throws CameraException Silent, Corrupt, Unplugged, Failed */
  bool
  next(Way way, WholeFrame& frame);

  /** \brief Ends the stream; does not throw when the camera was removed. */
  void
  end() noexcept;

  StreamCounts
  counts() const;

private:
  void
  begin(Way way);

  void
  ask();

  void
  beginAgain();

  void
  count(std::size_t StreamCounts::*what);

  bool
  isWhole(const IidcFrame& frame) const;

  bool
  mayBeSilent() const;

  std::optional<int>
  soundness(const IidcFrame& frame);

  void
  dropBroken(const IidcFrame& frame);

  bool
  accept(WholeFrame& frame);

  std::chrono::milliseconds
  patience() const;

  IidcCamera& camera_;
  std::atomic<int> interruptions_{0};
  IidcMode mode_;
  double period_ = 1;
  double patience_ = 1;
  bool has_counter_ = false;
  bool is_running_ = false;
  Way way_ = Way::Free;
  int under_way_ = 0; // frames that may have been exposed before the request
  int silences_ = 0;  // in a row
  int faults_ = 0;    // broken frames in a row
  FrameCount frame_count_;

  mutable std::mutex mutex_; // protects counts_
  StreamCounts counts_;
};

/** \brief The counter in the first bytes of a frame. */
std::uint32_t
counterOf(const IidcFrame& frame);

/** \brief Overwrites the counter with the pixels below it.
 * \param[in] rows distance in rows: 1, or 2 if a colour filter repeats after two
 * rows */
void
coverCounter(IidcFrame& frame, const IidcMode& mode, int rows);

} // namespace pcl::acmap
