#include "frame_count.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr double max_lost = 1e6; // frames at once; larger values are invalid

} // namespace

void
FrameCount::begin(double period)
{
  *this = FrameCount();
  period_ = period;
}

std::optional<int>
FrameCount::add(std::optional<std::uint32_t> counter, std::uint64_t stamp)
{
  double periods = 1;
  if (stamp_) // the difference is negative if the host's clock was set back
    periods =
        (static_cast<double>(stamp) - static_cast<double>(*stamp_)) * 1e-6 / period_;
  const std::optional<int> lost =
      counter ? lostByCounter(*counter, periods) : lostByTime(periods);
  if (lost)
    stamp_ = stamp;
  return lost;
}

std::optional<int>
FrameCount::lostByCounter(std::uint32_t counter, double periods)
{
  // The counter of a camera that was reset continues from another value, which is
  // accepted when two frames in a row confirm it.
  const bool is_new_count = odd_ && counter == *odd_ + 1;
  if (!counter_ || is_new_count) {
    odd_.reset();
    counter_ = counter;
    behind_ = 0;
    return 0;
  }
  const std::uint32_t step = counter - *counter_;
  // Frames that waited arrive in a burst, followed by the first frame after those that
  // did not fit into the buffers. Therefore the clock bounds the step only roughly, and
  // all periods that the counter is still behind are added.
  const double possible = 2.0 * std::max(periods, 0.0) + behind_ + 16;
  if (step == 0 || step > std::min(possible, max_lost)) {
    odd_ = counter;
    return std::nullopt;
  }
  odd_.reset();
  behind_ = std::max(behind_ + periods - step, 0.0);
  counter_ = counter;
  return static_cast<int>(step - 1);
}

int
FrameCount::lostByTime(double periods)
{
  int change = 0;
  if (periods > 1.5)
    change = static_cast<int>(std::lround(std::min(periods, max_lost))) - 1;
  else if (periods < 0.5 && missing_ > 0)
    change = -1;
  missing_ += change;
  return change;
}

} // namespace pcl::acmap
