#pragma once

#include <pcl/core/trinocular_frame.h>

#include <opencv2/core.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief A smoothed grey image for matching patches, with precomputed sums for the
 * correlation of each patch. */
class SmoothImage {
public:
  /** \brief A patch contains the pixels from -half to half - 1 around its pixel, in
   * both directions. */
  static constexpr int half = 8;
  static constexpr int side = 2 * half; ///< px

  struct Patch {
    std::array<std::int16_t, side * side> values;
    double sum = 0;
    float inverse_deviation = 0; ///< 1 / sqrt(sum of squared deviations)
  };

  explicit SmoothImage(const CameraImage& image);

  /** \brief Returns at most 200 corners, distributed over the image, in descending
   * order of strength. Each has a complete patch that differs from the patches beside
   * it. */
  std::vector<cv::Point>
  corners() const;

  /** \brief Returns true if there is a complete patch with contrast around a pixel. */
  bool
  hasPatch(int x, int y) const
  {
    return x >= half && y >= half && x + half <= grey_.cols && y + half <= grey_.rows &&
           inverse_deviation_(y, x) > 0.0F;
  }

  /** \brief The patch around a pixel; \ref hasPatch must be true. */
  Patch
  patchAt(cv::Point pixel) const;

  /** \brief Zero-mean normalised cross-correlation of a patch with the patch around a
   * pixel, in [-1, 1]; \ref hasPatch must be true. */
  float
  correlate(const Patch& patch, int x, int y) const;

private:
  /** \brief Returns true if the position of a corner is well defined in all directions,
   * which is not the case on an edge. */
  bool
  isDistinct(cv::Point corner) const;

  cv::Mat_<std::uint8_t> grey_;
  cv::Mat_<std::int32_t> sum_;        ///< sum over the patch around each pixel
  cv::Mat_<float> inverse_deviation_; ///< by patch; 0: no contrast
};

} // namespace pcl::acmap
