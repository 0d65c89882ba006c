#pragma once

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

/** \brief By what a pixel is compared. */
enum class PairCost {
  OverTime, ///< its levels in all shots
  Windows,  ///< those of a square round it
  Census,   ///< which of its neighbours are brighter
};

/** \brief Grey levels squared, added to the variance of what is compared: what changes no
 * more than its noise is like nothing. */
inline constexpr float variance_floor = 4.0F;

/** \brief How a number of shots is matched; measured, see doc/stereo/trinocular_matching.md.
 */
struct MatchingRecipe {
  PairCost cost = PairCost::OverTime;
  int radius = 0; ///< px, of the windows

  double blur = 0.6; ///< px, one standard deviation, of the images before all else

  /** \brief Whether each pixel is compared without its mean over the shots; else each
   * window without its mean. */
  bool centred = true;

  std::int16_t cost_of_bit = 12; ///< of the census

  std::int16_t small_penalty = 100; ///< P1; 2000 is what no correlation costs
  std::int16_t large_penalty = 400; ///< P2

  /** \brief Grey levels: the excess of P2 over P1 is half as large where the image changes
   * that much from pixel to pixel; 0: always the same. */
  int contrast = 0;

  double least_deviation = 2.0; ///< grey levels
  double least_correlation = 0.5;
};

/** \param[in] lit whether they were taken under patterns; one that was not is passive
 * stereo, where little is blank, edges are what counts, and no mask is needed */
MatchingRecipe
recipeOf(std::size_t shots, bool lit);

} // namespace pcl::acmap
