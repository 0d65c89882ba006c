#include "light_clock.h"

namespace pcl::acmap::test {

LightClock::LightClock(Milliseconds latency, Milliseconds fade)
: latency_(latency)
, fade_(fade)
{}

void
LightClock::change(double level)
{
  const std::lock_guard lock(mutex_);
  changes_.emplace_back(Clock::now(), level);
}

double
LightClock::told() const
{
  const std::lock_guard lock(mutex_);
  return changes_.empty() ? 0.0 : changes_.back().second;
}

/** Requires that mutex_ is locked. */
double
LightClock::at(Clock::time_point time) const
{
  double level = 0;
  for (const auto& [when, target] : changes_) {
    const Milliseconds since = time - when - latency_;
    if (since.count() < 0)
      break;
    level += (target - level) * (since < fade_ ? since / fade_ : 1.0);
  }
  return level;
}

double
LightClock::exposed(Clock::time_point begin, Milliseconds exposure) const
{
  constexpr int samples = 64;
  const std::lock_guard lock(mutex_);
  double sum = 0;
  for (int i = 0; i < samples; ++i)
    sum += at(begin + std::chrono::duration_cast<Clock::duration>(exposure * i /
                                                                  (samples - 1)));
  return sum / samples;
}

} // namespace pcl::acmap::test
