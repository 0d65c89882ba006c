#include "sequence/light_turns.h"
#include "sequence/shot_taker.h"

#include <pcl/acquisition/projector_latency.h>
#include <pcl/core/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace pcl {

namespace {

using acmap::LightChange;
using acmap::LightTurn;
using acmap::ShotTaker;
using Seconds = ShotTaker::Seconds;

constexpr Seconds turn_time{0.5};
constexpr Seconds tail{0.35}; // delay at which changes should be complete
constexpr Seconds shot_timeout{5};
constexpr int turns_wanted = 6;
constexpr int min_shots_of_turn = 3;
constexpr int trials_wanted = 6;

/** \brief The pixel values that increase when the projector is on. */
class LitValues {
public:
  LitValues(const TrinocularFrame& dark, const TrinocularFrame& bright)
  {
    std::array<std::size_t, 256> counts{};
    forEachRise(dark, bright, [&](std::size_t, std::size_t, int rise) {
      ++counts[static_cast<std::size_t>(std::max(rise, 0))];
    });
    const int minimum = std::max(2, topPercent(counts) / 2);
    forEachRise(dark, bright, [&](std::size_t camera, std::size_t i, int rise) {
      if (rise >= minimum)
        indices_[camera].push_back(i);
    });
    for (const auto& indices : indices_)
      size_ += indices.size();
  }

  bool
  empty() const
  {
    return size_ == 0;
  }

  double
  meanOf(const TrinocularFrame& frame) const
  {
    double sum = 0;
    for (std::size_t camera = 0; camera < indices_.size(); ++camera) {
      const auto& indices = indices_[camera];
      const auto& values = frame.images[camera].values;
      if (!indices.empty() && indices.back() >= values.size())
        throw acmap::IoFault(other_size);
      for (const std::size_t i : indices)
        sum += values[i];
    }
    return sum / static_cast<double>(size_);
  }

private:
  static constexpr const char* other_size = "the camera's frames differ in size";

  template <typename Use>
  static void
  forEachRise(const TrinocularFrame& dark,
              const TrinocularFrame& bright,
              const Use& use)
  {
    for (std::size_t camera = 0; camera < dark.images.size(); ++camera) {
      const auto& a = dark.images[camera].values;
      const auto& b = bright.images[camera].values;
      if (a.size() != b.size())
        throw acmap::IoFault(other_size);
      for (std::size_t i = 0; i < a.size(); ++i)
        use(camera, i, b[i] - a[i]);
    }
  }

  /** The smallest increase among the 1 % of values that increase most. */
  static int
  topPercent(const std::array<std::size_t, 256>& counts)
  {
    std::size_t all = 0;
    for (const std::size_t count : counts)
      all += count;
    std::size_t above = 0;
    std::size_t rise = counts.size();
    do {
      above += counts[--rise];
    } while (rise > 0 && above * 100 < all);
    return static_cast<int>(rise);
  }

  std::array<std::vector<std::size_t>, 3> indices_; // of each camera's image
  std::size_t size_ = 0;
};

class LatencyMeter {
public:
  LatencyMeter(ShotTaker& taker, const RgbImage& bright)
  : taker_(taker)
  , bright_(bright)
  {}

  std::optional<double>
  measure()
  {
    const TrinocularFrame::ConstPtr dark = shootAtEnd(nullptr);
    const TrinocularFrame::ConstPtr bright = shootAtEnd(&bright_);
    const LitValues lit(*dark, *bright);
    if (lit.empty())
      return std::nullopt;
    std::vector<LightTurn> turns;
    for (int i = 0; i < turns_wanted; ++i) {
      // The first shot is taken at different delays, to sample also the times between
      // shots.
      const Seconds first = longest_shot_ * (i / 2) / (turns_wanted / 2);
      turns.push_back(watch(i % 2 == 0 ? nullptr : &bright_, first, lit));
    }
    const auto change = acmap::findLightChange(turns, tail.count());
    if (!change)
      return std::nullopt;
    const double rate = static_cast<double>(taker_.camera().getFramesPerSecond());
    const Seconds period = rate > 0 ? Seconds(1 / rate) : longest_shot_;
    const std::optional<Seconds> confirmed = confirm(*change, period, lit);
    if (!confirmed)
      return std::nullopt;
    return (*confirmed + period).count();
  }

private:
  TrinocularFrame::ConstPtr
  shoot()
  {
    const auto begin = std::chrono::steady_clock::now();
    TrinocularFrame::ConstPtr frame = taker_.shoot(shot_timeout);
    longest_shot_ =
        std::max<Seconds>(longest_shot_, std::chrono::steady_clock::now() - begin);
    return frame;
  }

  TrinocularFrame::ConstPtr
  shootAtEnd(const RgbImage* image)
  {
    taker_.show(image);
    taker_.settle(turn_time);
    return shoot();
  }

  LightTurn
  watch(const RgbImage* image, Seconds first, const LitValues& lit)
  {
    LightTurn turn;
    taker_.show(image);
    taker_.settle(first);
    while (turn.size() < min_shots_of_turn || taker_.delay() < turn_time) {
      const TrinocularFrame::ConstPtr frame = shoot();
      turn.push_back({taker_.delay().count(), lit.meanOf(*frame)});
    }
    return turn;
  }

  /** Tries the delay as a sequence uses it: one shot after each change. The images that a
   * driver buffers meanwhile are older than those between two shots of a turn.
   * \return the delay, or the next one, later by periods, that leaves all changes complete;
   * nothing if it is longer than a change may take */
  std::optional<Seconds>
  confirm(const LightChange& change, Seconds period, const LitValues& lit)
  {
    Seconds delay(change.settled);
    for (int passed = 0; passed < trials_wanted;) {
      const bool to_bright = passed % 2 == 1; // the last turn ended bright
      taker_.show(to_bright ? &bright_ : nullptr);
      taker_.settle(delay);
      if (change.isComplete(lit.meanOf(*shoot()), to_bright)) {
        ++passed;
        continue;
      }
      passed = 0;
      delay += period;
      if (delay > tail)
        return std::nullopt;
      shootAtEnd(&bright_);
    }
    return delay;
  }

  ShotTaker& taker_;
  const RgbImage& bright_;
  Seconds longest_shot_{0};
};

} // namespace

std::optional<double>
measureSettleTime(const shared_ptr<TrinocularGrabber>& camera,
                  const shared_ptr<PatternProjector>& projector,
                  const RgbImage& bright)
{
  ShotTaker taker(camera, projector);
  std::optional<double> seconds;
  try {
    seconds = LatencyMeter(taker, bright).measure();
  }
  catch (...) {
    try {
      taker.finish();
    }
    catch (...) { // the first error is more informative
    }
    throw;
  }
  taker.finish();
  return seconds;
}

} // namespace pcl
