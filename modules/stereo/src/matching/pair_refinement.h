#pragma once

#include "pair_costs.h"
#include "pair_winners.h"

#include <vector>

namespace pcl::acmap {

/** \brief Sub-pixel match of each pixel, row by row from the top. */
struct RefinedPair {
  std::vector<float> disparity; ///< px
  std::vector<float>
      correlation; ///< ZNCC there: minimum of that of the window and of the pixel's own
  std::vector<float> sigma;     ///< px, one standard deviation
  std::vector<float> deviation; ///< standard deviation of the reference, grey levels

  void
  resize(std::size_t pixels);
};

/** \brief Moves each winner, by about half a pixel at most, to the maximum of the
 * correlation of a 5 x 5 window among quarter pixels, and then to the vertex of a
 * parabola through three of them. The window contains only the pixels whose own winners
 * differ by at most 1. Runs in all threads of the caller's arena.
 * \param[in] centred as in \ref MatchingRecipe */
void
refineWinners(const ShotStack& reference,
              const ShotStack& target,
              const PairWinners& winners,
              const DisparityRange& range,
              bool centred,
              RefinedPair& refined);

} // namespace pcl::acmap
