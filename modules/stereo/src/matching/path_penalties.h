#pragma once

#include "pair_winners.h"
#include "shot_stack.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief P2 for the steps of each path, depending on the contrast of the image
 * (Hirschmueller 2008, section 2.3). */
class PenaltyRows {
public:
  PenaltyRows(const ShotStack& image, const PathSettings& settings, bool up)
  : image_(image)
  , settings_(settings)
  , up_(up)
  {
    for (std::vector<std::int16_t>& row : rows_)
      row.assign(static_cast<std::size_t>(image.width()), settings.large_penalty);
  }

  /** \brief The result is valid until the next call. */
  PathPenalties
  row(int y);

private:
  std::int16_t
  penaltyOf(int level, int other) const;

  const ShotStack& image_;
  PathSettings settings_;
  bool up_;
  std::array<std::vector<std::int16_t>, 4> rows_;
};

} // namespace pcl::acmap
