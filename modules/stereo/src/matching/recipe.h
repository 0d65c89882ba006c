#pragma once

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

/** \brief The values by which pixels are compared. */
enum class PairCost {
  OverTime, ///< grey levels of the pixel in all shots
  Windows,  ///< grey levels of a square window around it
  Census,   ///< signs of the differences to its neighbours
};

/** \brief Added to the variances of the compared values, in squared grey levels: values
 * that vary no more than by noise do not correlate with anything. */
inline constexpr float variance_floor = 4.0F;

/** \brief Parameters of the matching for a number of shots; determined by measurements,
 * see doc/stereo/trinocular_matching.md. */
struct MatchingRecipe {
  PairCost cost = PairCost::OverTime;
  int radius = 0; ///< of the windows, px

  double blur = 0.6; ///< standard deviation of the blur before the matching, px

  /** \brief If true, the mean over the shots is subtracted from each pixel; otherwise
   * the mean of each window is subtracted. */
  bool centred = true;

  std::int16_t cost_of_bit = 12; ///< cost of a bit of the census

  std::int16_t small_penalty = 100; ///< P1; no correlation costs 2000
  std::int16_t large_penalty = 400; ///< P2

  /** \brief Grey levels: P2 - P1 is halved if the image changes by this amount from
   * pixel to pixel; 0: P2 is constant. */
  int contrast = 0;

  double min_deviation = 2.0; ///< grey levels
  double min_correlation = 0.5;
};

/** \param[in] lit true if the shots were taken under patterns. A shot without a pattern
 * is treated as passive stereo: most surfaces are textured, edges must be preserved,
 * and no mask is needed */
MatchingRecipe
recipeOf(std::size_t shots, bool lit);

} // namespace pcl::acmap
