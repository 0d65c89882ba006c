#pragma once

#include "shot_statistics.h"

#include <pcl/stereo/matched_disparity.h>

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Fuses the shots of pixels that do not decide alone, because they are too few or
 * contradict each other: those count that most disparities of the pixels around confirm,
 * in all shots. */
class ConfirmedShots {
public:
  /** \param[in] shots must outlive the object
   * \param[in] min_support fewer than three times as many disparities around a pixel
   * confirm nothing */
  ConfirmedShots(const std::vector<MatchedDisparity>& shots, std::size_t min_support);

  /** \param[in] begin, end the shots of the pixel, sorted, at least one
   * \return nothing if too few of them are confirmed */
  std::optional<FusedDisparity>
  fuse(const ShotDisparity* begin, const ShotDisparity* end, std::size_t pixel);

private:
  void
  collectAround(std::size_t pixel);

  /** \brief Number of disparities around that agree with this one. */
  std::size_t
  confirmationsOf(float disparity) const;

  const std::vector<MatchedDisparity>& shots_;
  std::size_t min_around_;
  std::vector<float> around_; // px
};

} // namespace pcl::acmap
