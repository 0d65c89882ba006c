#pragma once

#include <chrono>
#include <mutex>
#include <utility>
#include <vector>

namespace pcl::acmap::test {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

/** \brief Brightness of the projector's light as a function of time. */
class LightClock {
public:
  /** \param[in] latency from the request to the first change of the light
   * \param[in] fade duration of the change */
  explicit LightClock(Milliseconds latency = Milliseconds(0),
                      Milliseconds fade = Milliseconds(0));

  /** \brief Records a request to the projector at the current time. */
  void
  change(double level);

  /** \brief Mean brightness over an exposure. */
  double
  exposed(Clock::time_point begin, Milliseconds exposure) const;

  /** \brief The last requested level. */
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
