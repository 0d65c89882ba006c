#include "path_penalties.h"

#include <cstdlib>

namespace pcl::acmap {

std::int16_t
PenaltyRows::penaltyOf(int level, int other) const
{
  const int contrast = settings_.contrast * ShotStack::unit;
  const int span = settings_.large_penalty - settings_.small_penalty;
  return static_cast<std::int16_t>(
      settings_.small_penalty + span * contrast / (contrast + std::abs(level - other)));
}

PathPenalties
PenaltyRows::row(int y)
{
  const int ahead = up_ ? -1 : 1;
  if (settings_.contrast > 0) {
    // The border repeats the outermost pixels, so a step from outside has no contrast.
    const std::int16_t* const levels = image_.rows(y).values;
    const std::int16_t* const before = image_.rows(y - ahead).values;
    for (int x = 0; x < image_.width(); ++x) {
      const auto at = static_cast<std::size_t>(x);
      rows_[0][at] = penaltyOf(levels[x], levels[x - ahead]);
      for (int path = 0; path < 3; ++path)
        rows_[static_cast<std::size_t>(path) + 1][at] =
            penaltyOf(levels[x], before[x + (path - 1) * ahead]);
    }
  }
  PathPenalties penalties{};
  penalties.small = settings_.small_penalty;
  penalties.beside = rows_[0].data();
  for (std::size_t path = 0; path < 3; ++path)
    penalties.above[path] = rows_[path + 1].data();
  return penalties;
}

} // namespace pcl::acmap
