#pragma once

#include <pcl/core/image_file.h>

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace pcl::acmap::test {

/** \brief Continuously watches the screen of the environment's display, as a camera
 * would watch the wall, and detects which pattern is shown. */
class ProjectorWatch {
public:
  using Clock = std::chrono::steady_clock;

  static constexpr int dark = -1;
  static constexpr int something_else = -2;

  /** \param[in] patterns have the size of the screen */
  explicit ProjectorWatch(const std::vector<RgbImage>& patterns);
  ~ProjectorWatch();

  ProjectorWatch(const ProjectorWatch&) = delete;
  ProjectorWatch&
  operator=(const ProjectorWatch&) = delete;

  /** \brief Sets the latency of the projector relative to the screen. */
  void
  setDelay(std::chrono::milliseconds delay)
  {
    delay_ = delay;
  }

  /** \brief Numbers of all patterns that were on the wall within a time interval; waits
   * until the screen was checked after its end. */
  std::set<int>
  shownWithin(Clock::time_point begin, Clock::time_point end) const;

private:
  using Row = std::vector<std::uint8_t>;

  void
  watch();

  int
  patternOf(const std::vector<Row>& rows) const;

  std::vector<std::vector<Row>> rows_; ///< rows of each pattern that are compared
  std::atomic<std::chrono::milliseconds> delay_{std::chrono::milliseconds(0)};
  mutable std::mutex mutex_;
  mutable std::condition_variable looked_;
  Clock::time_point last_look_; ///< start of the last completed check
  /** \brief Time of each change, new pattern. */
  std::vector<std::pair<Clock::time_point, int>> changes_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

} // namespace pcl::acmap::test
