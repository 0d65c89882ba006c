#pragma once

#include <pcl/core/point_types.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/stereo/matched_disparity.h>

#include <cstddef>

namespace pcl::acmap {

/** \brief Depths in metres; both limits are valid depths. */
struct DepthLimits {
  double minimum = 0.0;
  double largest = 0.0;
};

/** \brief Numbers of pixels, as in \ref DisparityBackProjectionReport. */
struct PixelCounts {
  std::size_t points = 0;
  std::size_t invalid = 0;
  std::size_t too_near = 0;
  std::size_t too_far = 0;
};

/** \brief Computes the points of one disparity image, each independently. */
class PixelProjection {
public:
  /** \brief All arguments must be of one size and outlive this object. Without standard
   * deviations that of the rig is used; without colour, points are black. */
  PixelProjection(const TrinocularRig& rig,
                  const DepthLimits& limits,
                  const MatchedDisparity& matched,
                  const CameraImage& color);

  /** \brief Runs in all threads of the caller's arena.
   * \param[in,out] points one per pixel, default-constructed
   * \param[in] size number of pixels */
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
  const double focal_baseline_; // depth times disparity with its offset, px m
  const double offset_;         // px
};

} // namespace pcl::acmap
