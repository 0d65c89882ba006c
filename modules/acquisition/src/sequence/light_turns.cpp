#include "sequence/light_turns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pcl::acmap {

namespace {

constexpr double min_turn = 1.0; // grey levels, minimum change of the mean
constexpr double change_to_wait_for = 0.95;
constexpr double max_unrest = 0.3; // maximum, relative to the contrast

/** \brief Level at the end of a turn, and its fluctuation there. */
struct TurnEnd {
  double level = 0;
  double unrest = 0; // grey levels, half the range
};

TurnEnd
endOf(const LightTurn& turn, double tail)
{
  double sum = 0;
  double minimum = turn.back().level;
  double maximum = minimum;
  std::size_t samples = 0;
  for (const LightSample& sample : turn)
    if (sample.delay >= tail || &sample == &turn.back()) {
      sum += sample.level;
      minimum = std::min(minimum, sample.level);
      maximum = std::max(maximum, sample.level);
      ++samples;
    }
  return {sum / static_cast<double>(samples), (maximum - minimum) / 2};
}

} // namespace

std::optional<LightChange>
findLightChange(const std::vector<LightTurn>& turns, double tail)
{
  std::vector<TurnEnd> ends;
  for (const LightTurn& turn : turns)
    ends.push_back(endOf(turn, tail));

  double contrast = std::numeric_limits<double>::infinity();
  double unrest = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    unrest = std::max(unrest, ends[i].unrest);
    if (i > 0) // turns with odd index lead to bright
      contrast = std::min(contrast,
                          (ends[i].level - ends[i - 1].level) * (i % 2 == 1 ? 1 : -1));
    if (i > 1) // change of the ambient light
      unrest = std::max(unrest, std::abs(ends[i].level - ends[i - 2].level) / 2);
  }
  if (contrast < min_turn || unrest > max_unrest * contrast)
    return std::nullopt;

  const double wanted = std::min(change_to_wait_for, 1 - 2 * unrest / contrast);
  const auto isSettled = [&](std::size_t turn, const LightSample& sample) {
    const double from = ends[turn == 0 ? 1 : turn - 1].level;
    return (sample.level - from) / (ends[turn].level - from) >= wanted;
  };
  double unsettled = -1; // the longest delay at which a change was incomplete
  for (std::size_t i = 0; i < turns.size(); ++i)
    for (const LightSample& sample : turns[i])
      if (!isSettled(i, sample))
        unsettled = std::max(unsettled, sample.delay);
  std::optional<double> settled;
  for (const LightTurn& turn : turns)
    for (const LightSample& sample : turn)
      if (sample.delay > unsettled && (!settled || sample.delay < *settled))
        settled = sample.delay;
  if (!settled)
    return std::nullopt;
  const std::size_t last_bright = (turns.size() / 2) * 2 - 1;
  const std::size_t last_dark = (turns.size() - 1) / 2 * 2;
  return LightChange{*settled, ends[last_dark].level, ends[last_bright].level, wanted};
}

} // namespace pcl::acmap
