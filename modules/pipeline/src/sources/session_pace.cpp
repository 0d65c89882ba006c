#include <pcl/pipeline/session_pace.h>

#include <algorithm>
#include <thread>
#include <utility>

namespace pcl {

SessionPace::SessionPace(std::function<void()> idle)
: idle_(std::move(idle))
{}

void
SessionPace::operator()(const TrinocularFrame& frame)
{
  using Clock = std::chrono::steady_clock;
  constexpr std::uint64_t longest = 60000000; // microseconds
  constexpr std::chrono::milliseconds step(100);
  const std::uint64_t before = stamp_.value_or(frame.stamp);
  if (!stamp_)
    due_ = Clock::now();
  stamp_ = frame.stamp;
  if (frame.stamp > before)
    due_ += std::chrono::microseconds(std::min(frame.stamp - before, longest));
  while (Clock::now() < due_) {
    if (idle_)
      idle_();
    std::this_thread::sleep_until(std::min(due_, Clock::now() + step));
  }
}

} // namespace pcl
