#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Disparity of a pixel from one shot. */
struct ShotDisparity {
  float disparity; ///< px
  float sigma;     ///< px, one standard deviation
};

/** \brief Disparity of a pixel from all shots. */
struct FusedDisparity {
  float disparity;       ///< px
  float sigma;           ///< px, one standard deviation
  std::uint16_t support; ///< number of shots
  bool is_consistent;    ///< false if the shots contradict each other
};

/** \brief Orders the disparities of a pixel, so that neither of the functions below
 * depends on the order of the shots. */
void
sortShots(ShotDisparity* begin, ShotDisparity* end);

/** \brief The lower median; always consistent.
 * \param[in] begin, end sorted, at least one */
FusedDisparity
medianOfShots(const ShotDisparity* begin, const ShotDisparity* end);

/** \brief The weighted mean of the disparities within three robust standard deviations
 * of the median (at least 1 px), which are at least half of them. It is inconsistent if
 * too few shots agree with it, or if their scatter is too large for their variances.
 * \param[in] begin, end sorted, at least one */
FusedDisparity
consistentMeanOfShots(const ShotDisparity* begin, const ShotDisparity* end);

/** \brief Are disparities (px) those of one surface: at most 1 px apart? */
bool
agree(float a, float b);

/** \brief Returns true if so many of all disparities are taken for the true one: 60 %. */
bool
isMajority(std::size_t agreed, std::size_t all);

/** \brief The value that a chi-square variable exceeds with a probability of 1 % (the
 * approximation of Wilson and Hilferty, accurate to 1 %); infinite for 0 degrees of
 * freedom. */
double
chiSquareLimit(std::size_t degrees_of_freedom);

} // namespace pcl::acmap
