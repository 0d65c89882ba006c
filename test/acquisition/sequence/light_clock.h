#pragma once

#include <chrono>
#include <mutex>
#include <utility>
#include <vector>

namespace pcl::acmap::test {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

/** \brief How bright the projector's light was and will be, by the time. */
class LightClock {
public:
  /** \param[in] latency from change to light
   * \param[in] fade how long the light then takes to its end */
  explicit LightClock(Milliseconds latency = Milliseconds(0),
                      Milliseconds fade = Milliseconds(0));

  /** \brief The projector was told now. */
  void
  change(double level);

  /** \brief Mean over an exposure. */
  double
  exposed(Clock::time_point begin, Milliseconds exposure) const;

  /** \brief What the projector was told last. */
  double
  told() const;

private:
  double
  at(Clock::time_point time) const;

  const Milliseconds latency_;
  const Milliseconds fade_;

  mutable std::mutex mutex_;
  std::vector<std::pair<Clock::time_point, double>> changes_;
};

} // namespace pcl::acmap::test
