#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

/** \brief Few numbers of a patch by which its scores are bounded from above.
 *
 * A patch is the sum of orthonormal waves over its rings and sectors. For two patches
 * with the amplitudes p and q of the longest waves, and the lengths r and s of what
 * remains, a score is at most p . q + r s (Cauchy-Schwarz). As waves of images are long
 * ones, this excludes nearly all pairs. */
class PatchWaves {
public:
  /** \brief Numbers of a patch: amplitudes of waves, and the length of what remains. */
  static constexpr std::size_t size = 32;

  PatchWaves(int rings, int sectors);

  /** \param[in] samples of a patch as integers, ring by ring
   * \param[out] numbers \ref size integers */
  void
  numbersOf(const std::int16_t* samples, std::int16_t* numbers) const;

  /** \brief A score that is above \a score has a product of numbers above this one;
   * the difference is more than the rounding of the numbers can make. */
  static std::int32_t
  boundOf(std::int32_t score);

private:
  Eigen::MatrixXf waves_; ///< one per row
};

} // namespace pcl::acmap
