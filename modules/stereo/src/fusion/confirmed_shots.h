#pragma once

#include "shot_statistics.h"

#include <pcl/stereo/matched_disparity.h>

#include <vector>

namespace pcl::acmap {

/** \brief Fuses pixels whose own shots do not decide, because they are too few or
 * contradict each other: of their disparities those count that most disparities of the
 * pixels around them confirm, in all shots. */
class ConfirmedShots {
public:
  /** \param[in] shots must outlive the object
   * \param[in] min_support fewer than three times as many disparities around a pixel
   * confirm nothing */
  ConfirmedShots(const std::vector<MatchedDisparity>& shots, std::size_t min_support);

  /** \brief Sets a pixel of an image of the size of the shots; leaves it as it is if none
   * of its own disparities is confirmed. */
  void
  fuse(std::size_t pixel, MatchedDisparity& fused);

private:
  void
  collectOwn(std::size_t pixel);

  void
  collectAround(std::size_t pixel);

  /** \brief Number of disparities around that agree with this one. */
  std::size_t
  confirmationsOf(float disparity) const;

  const std::vector<MatchedDisparity>& shots_;
  std::size_t min_around_;
  std::vector<ShotDisparity> own_;
  std::vector<float> around_; // px
};

} // namespace pcl::acmap
