#pragma once

#include <pcl/core/trinocular_frame.h>

#include <opencv2/core.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief A grey image to look for patches in: some noise is off, and what correlations
 * need to know of each patch is summed up. */
class SmoothImage {
public:
  /** \brief A patch reaches from -half to half - 1 round its pixel, in both directions. */
  static constexpr int half = 8;
  static constexpr int side = 2 * half; ///< px

  struct Patch {
    std::array<std::int16_t, side * side> values;
    double sum = 0;
    float inverse_deviation = 0; ///< 1 / sqrt (squared deviations' sum)
  };

  explicit SmoothImage(const CameraImage& image);

  /** \brief At most 200 corners, the strongest first, spread over the image: each with a
   * whole patch that none of those beside it looks like. */
  std::vector<cv::Point>
  corners() const;

  /** \brief Whether there is a whole patch with contrast round a pixel. */
  bool
  hasPatch(int x, int y) const
  {
    return x >= half && y >= half && x + half <= grey_.cols && y + half <= grey_.rows &&
           inverse_deviation_(y, x) > 0.0F;
  }

  /** \brief The patch that there is. */
  Patch
  patchAt(cv::Point pixel) const;

  /** \brief Zero-mean normalised correlation of a patch with the one that there is round
   * a pixel, in [-1, 1]. */
  float
  correlate(const Patch& patch, int x, int y) const;

private:
  /** \brief Whether a corner's place can be told in every direction: on an edge it
   * cannot. */
  bool
  isDistinct(cv::Point corner) const;

  cv::Mat_<std::uint8_t> grey_;
  cv::Mat_<std::int32_t> sum_;        ///< of the patch round each pixel, likewise below
  cv::Mat_<float> inverse_deviation_; ///< 0: no contrast
};

} // namespace pcl::acmap
