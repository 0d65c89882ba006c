#pragma once

#include "pair_costs.h"
#include "pair_winners.h"

#include <vector>

namespace pcl::acmap {

/** \brief What is known of each pixel's match to a part of a pixel, rows from the top. */
struct RefinedPair {
  std::vector<float> disparity; ///< px
  std::vector<float>
      correlation; ///< ZNCC there, of the window or, if less, of the pixel over time
  std::vector<float> sigma;     ///< px, one standard deviation
  std::vector<float> deviation; ///< grey levels, of the reference's values compared

  void
  resize(std::size_t pixels);
};

/** \brief Moves each winner, by about half a pixel at most, to where the correlation of a
 * window of 5 x 5 is highest among quarter pixels, and of a parabola through three of
 * them. Of the window count the pixels whose own winners differ by at most 1. Runs in all
 * threads of the caller's arena.
 * \param[in] centred as in \ref MatchingRecipe */
void
refineWinners(const ShotStack& reference,
              const ShotStack& target,
              const PairWinners& winners,
              const DisparityRange& range,
              bool centred,
              RefinedPair& refined);

} // namespace pcl::acmap
