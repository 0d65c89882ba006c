#include "camera_stream.h"

#include <algorithm>
#include <string>

namespace pcl::acmap {

namespace {

/** Number of buffered frames: half a second at the paper's rate, so that slow callbacks
 * lose no frame. The buffers of two cameras stay below 16 MB, the limit of Linux for
 * all USB devices together. */
constexpr std::size_t frames_in_flight = 8;
constexpr std::size_t single_frames_in_flight = 2;

/** Number of frames to discard when a single frame is requested from a camera without
 * one-shot: one frame is in transfer and one is being exposed. */
constexpr int max_under_way = 2;

constexpr int max_silences = 2;
constexpr int max_faults = 10;
constexpr std::size_t counter_bytes = 4;

} // namespace

void
CameraStream::setUp(const IidcMode& mode, double rate, double patience)
{
  mode_ = mode;
  period_ = 1.0 / rate;
  patience_ = patience;
  has_counter_ = camera_.hasFrameCounter();
}

std::chrono::milliseconds
CameraStream::patience() const
{
  return std::chrono::milliseconds(
      static_cast<long>(1000.0 * (3.0 * period_ + patience_)));
}

StreamCounts
CameraStream::counts() const
{
  const std::lock_guard lock(mutex_);
  return counts_;
}

void
CameraStream::count(std::size_t StreamCounts::*what)
{
  const std::lock_guard lock(mutex_);
  ++(counts_.*what);
}

void
CameraStream::begin(Way way)
{
  way_ = way;
  camera_.open();
  camera_.startStream(way == Way::Free ? frames_in_flight : single_frames_in_flight);
  is_running_ = true;
  frame_count_.begin(period_);
  if (way == Way::Free || !camera_.hasOneShot())
    camera_.runFreely();
}

void
CameraStream::end() noexcept
{
  if (is_running_)
    camera_.stopStream();
  is_running_ = false;
  silences_ = 0;
  faults_ = 0;
}

/** Requests one frame and discards the frames that arrived before the request. */
void
CameraStream::ask()
{
  IidcFrame old;
  constexpr std::chrono::milliseconds no_time(0);
  for (std::size_t i = 0; i < 2 * single_frames_in_flight; ++i) {
    if (camera_.nextFrame(old, no_time) != IidcWait::Frame)
      break;
    count(&StreamCounts::early);
  }
  under_way_ = camera_.hasOneShot() ? 0 : max_under_way;
  if (camera_.hasOneShot())
    camera_.takeOne();
}

/** Restarts a stream that has fallen silent.
 * \throws CameraException Silent when earlier restarts did not help */
void
CameraStream::beginAgain()
{
  if (++silences_ > max_silences)
    throw CameraException(CameraFault::Silent,
                          camera_.place() + ": no frame came for " +
                              std::to_string(patience().count()) + " ms, " +
                              std::to_string(silences_) + " times in a row");
  count(&StreamCounts::restarts);
  camera_.stopStream();
  is_running_ = false;
  begin(way_);
  if (way_ == Way::Single)
    ask();
}

bool
CameraStream::isWhole(const IidcFrame& frame) const
{
  // Some cameras do not transmit the padding of the last packet.
  return frame.bytes.size() >= mode_.bytes() && mode_.bytes() >= counter_bytes;
}

bool
CameraStream::mayBeSilent() const
{
  return camera_.trigger() == IidcTrigger::External;
}

/** \return the number of frames that were lost before this frame, nothing if it is
 * broken */
std::optional<int>
CameraStream::soundness(const IidcFrame& frame)
{
  if (!isWhole(frame))
    return std::nullopt;
  // Without a counter, lost frames cannot be detected by time if an external trigger
  // determines the time between frames.
  if (way_ == Way::Single || (mayBeSilent() && !has_counter_))
    return 0;
  return frame_count_.add(has_counter_ ? std::optional(counterOf(frame)) : std::nullopt,
                          frame.stamp);
}

void
CameraStream::dropBroken(const IidcFrame& frame)
{
  count(&StreamCounts::broken);
  if (++faults_ > max_faults)
    throw CameraException(CameraFault::Corrupt,
                          camera_.place() + ": " + std::to_string(faults_) +
                              " frames in a row were broken, the last one of " +
                              std::to_string(frame.bytes.size()) +
                              " bytes, where a frame has " +
                              std::to_string(mode_.bytes()));
  if (way_ == Way::Single && camera_.hasOneShot())
    camera_.takeOne();
}

/** \return true if the frame is to be passed on */
bool
CameraStream::accept(WholeFrame& frame)
{
  const std::optional<int> lost = soundness(frame.data);
  if (!lost) {
    dropBroken(frame.data);
    return false;
  }
  if (under_way_ > 0) {
    --under_way_;
    count(&StreamCounts::early);
    return false;
  }
  silences_ = 0;
  faults_ = 0;
  frame.lost = has_counter_ ? static_cast<std::size_t>(*lost) : 0;
  const std::lock_guard lock(mutex_);
  counts_.lost += *lost;
  return true;
}

bool
CameraStream::next(Way way, WholeFrame& frame)
{
  if (is_running_ && way != way_)
    end();
  if (!is_running_)
    begin(way);
  if (way == Way::Single)
    ask();
  // A new stream resets the cancellation of the bus, but not the interruption.
  while (interruptions_ == 0) {
    switch (camera_.nextFrame(frame.data, patience())) {
    case IidcWait::Cancelled:
      break;
    case IidcWait::TimedOut:
      if (!mayBeSilent())
        beginAgain();
      break;
    case IidcWait::Frame:
      if (accept(frame))
        return true;
      break;
    }
  }
  return false;
}

std::uint32_t
counterOf(const IidcFrame& frame)
{
  std::uint32_t counter = 0;
  for (std::size_t i = 0; i < counter_bytes; ++i)
    counter = counter << 8 | frame.bytes[i];
  return counter;
}

void
coverCounter(IidcFrame& frame, const IidcMode& mode, int rows)
{
  const std::size_t below = static_cast<std::size_t>(rows) *
                            static_cast<std::size_t>(mode.width) *
                            static_cast<std::size_t>(mode.cameras());
  if (below + counter_bytes <= frame.bytes.size())
    std::copy_n(frame.bytes.begin() + static_cast<std::ptrdiff_t>(below),
                counter_bytes,
                frame.bytes.begin());
}

} // namespace pcl::acmap
