#pragma once

#include <pcl/core/point_types.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/stereo/matched_disparity.h>

#include <cstddef>

namespace pcl::acmap {

/** \brief Metres; both are legal. */
struct DepthLimits {
  double least = 0.0;
  double largest = 0.0;
};

/** \brief What became of pixels, as \ref DisparityBackProjectionReport has it. */
struct PixelCounts {
  std::size_t points = 0;
  std::size_t invalid = 0;
  std::size_t too_near = 0;
  std::size_t too_far = 0;
};

/** \brief Makes the points of one disparity image, each by itself. */
class PixelProjection {
public:
  /** \brief All are of one size and must outlive this; no standard deviations: those of
   * the rig; no colour: black. */
  PixelProjection(const TrinocularRig& rig,
                  const DepthLimits& limits,
                  const MatchedDisparity& matched,
                  const CameraImage& color);

  /** \brief In all threads of the caller's arena.
   * \param[in,out] points one a pixel, as constructed
   * \param[in] size how many */
  PixelCounts
  projectAll(PointXYZRGBSigma* points, std::size_t size) const;

private:
  void
  paint(std::size_t pixel, PointXYZRGBSigma& point) const;

  std::size_t PixelCounts::*
  place(std::size_t pixel, PointXYZRGBSigma& point) const;

  void
  setPlace(std::size_t pixel, double z, PointXYZRGBSigma& point) const;

  double
  disparitySigma(std::size_t pixel) const;

  const TrinocularRig& rig_;
  const DepthLimits limits_;
  const MatchedDisparity& matched_;
  const CameraImage& color_;
  const double focal_baseline_; // px m: depth times disparity
};

} // namespace pcl::acmap
