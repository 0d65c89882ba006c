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

/** \brief What became of the frames of a camera. */
struct StreamCounts {
  long lost = 0;
  std::size_t broken = 0;
  std::size_t early = 0;
  std::size_t restarts = 0;
};

/** \brief A whole frame. */
struct WholeFrame {
  IidcFrame data;
  std::size_t lost = 0; ///< before it, as the camera counted
};

/** \brief Whole frames of a camera, whatever its stream goes through. For one thread, but
 * for the counts. */
class CameraStream {
public:
  enum class Way {
    Free,  ///< one after another
    Single ///< each exposed after it was asked for
  };

  /** \brief While one lives, nobody waits for a frame: \ref next gives none. For any
   * thread. */
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

  /** \brief How frames will be, from the next stream on.
   * \param[in] mode their size
   * \param[in] rate frames a second
   * \param[in] patience seconds beyond three periods, after which it has fallen silent */
  void
  setUp(const IidcMode& mode, double rate, double patience);

  /** \brief Begins where nothing runs, opening the camera where it is closed, and waits
   * for a whole frame.
   * \return false when it was interrupted
   * \throws CameraException Silent, Corrupt, Unplugged, Failed */
  bool
  next(Way way, WholeFrame& frame);

  /** \brief No more frames; does not throw when the camera is gone. */
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
  int under_way_ = 0; // frames that may be exposed before they were asked for
  int silences_ = 0;  // in a row
  int faults_ = 0;    // broken frames in a row
  FrameCount frame_count_;

  mutable std::mutex mutex_; // of the counts
  StreamCounts counts_;
};

/** \brief The counter in the first bytes of a frame. */
std::uint32_t
counterOf(const IidcFrame& frame);

/** \brief Fills the place of the counter with what stands below it.
 * \param[in] rows 1, or 2 where a colour filter repeats itself after two */
void
coverCounter(IidcFrame& frame, const IidcMode& mode, int rows);

} // namespace pcl::acmap
