#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief What one shot tells of a pixel. */
struct ShotDisparity {
  float disparity; ///< px
  float sigma;     ///< px, one standard deviation
};

/** \brief What all shots together tell of it. */
struct FusedDisparity {
  float disparity;       ///< px
  float sigma;           ///< px, one standard deviation
  std::uint16_t support; ///< shots
  bool is_consistent;    ///< false: the shots tell different disparities
};

/** \brief Orders the disparities of a pixel, so that neither of the functions below
 * depends on the order of the shots. */
void
sortShots(ShotDisparity* begin, ShotDisparity* end);

/** \brief The lower median; always consistent.
 * \param[in] begin, end sorted, at least one */
FusedDisparity
medianOfShots(const ShotDisparity* begin, const ShotDisparity* end);

/** \brief The mean of those within three robust deviations of the median, at least 1 px:
 * half of them or more; consistent unless their scatter is too large for what is known of
 * it.
 * \param[in] begin, end sorted, at least one */
FusedDisparity
consistentMeanOfShots(const ShotDisparity* begin, const ShotDisparity* end);

/** \brief What a sum of the squares of normal deviates exceeds once in a hundred times
 * (Wilson and Hilferty's approximation, to 1 %); infinite for none. */
double
chiSquareLimit(std::size_t degrees_of_freedom);

} // namespace pcl::acmap
