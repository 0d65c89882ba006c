#pragma once

#include "bench.h"
#include "stereo_shots.h"

#include <pcl/core/disparity_image.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/stereo/disparity_fusion.h>

namespace pcl::acmap::bench {

/** \brief Parameters of OpenCV's StereoSGBM. */
struct SgbmSetting {
  int minimum = 0;      ///< px
  int disparities = 64; ///< a multiple of 16
  int prefilter = 15;   ///< grey levels, clipping of its gradients; the default

  /** \brief Uniqueness (5 %), speckles (100 px, 2 px) and the left-right check (1 px);
   * false: only those that cannot be switched off. */
  bool filters = true;

  /** \brief Widens the images by the maximum disparity, because SGBM leaves this number
   * of columns empty. */
  bool padded = true;
};

/** \brief Disparities of the reference and its horizontal neighbour from OpenCV's
 * semi-global block matching of their grey images. */
DisparityImage
sgbmDisparity(const TrinocularFrame& frame,
              const TrinocularRig& rig,
              const SgbmSetting& setting);

/** \brief As above for each shot. */
std::vector<DisparityImage>
sgbmDisparities(const std::vector<TrinocularFrame::ConstPtr>& frames,
                const TrinocularRig& rig,
                const SgbmSetting& setting);

/** \brief The lower median at each pixel with at least 3 disparities. */
DisparityImage
medianDisparity(const std::vector<DisparityImage>& images);

/** \brief All shots together.
 * \param[in] matching its settings */
MatchedDisparity
fusedDisparity(const StereoShots& shots,
               DisparityFusion::Method method,
               const TrinocularMatching& matching = {});

/** \brief Back-projects a pixel with a disparity, metres in the camera frame.
 * \param[in] pixel its index in row-major order */
Eigen::Vector3d
pointOf(const TrinocularRig& rig, std::size_t pixel, double disparity);

/** \brief Errors of disparities; accumulates several images. */
class DisparityErrors {
public:
  /** \brief An error above this is bad, px. */
  static constexpr double bad_error = 1.0;

  /** \brief Compares an image with the truth at the pixels of a mask, which must have a
   * true disparity. */
  void
  add(const DisparityImage& found, const DisparityImage& truth, const PixelMask& mask);

  /** \brief Percentage of the evaluated pixels that are bad or have no disparity. */
  double
  bad() const;

  /** \brief Percentage of the evaluated pixels that have a disparity, correct or
   * not. */
  double
  present() const;

  /** \brief Percentage of the evaluated pixels that have a bad disparity. */
  double
  wrong() const;

  /** \brief Median of the absolute errors of all disparities, px. */
  double
  medianError() const;

  /** \brief RMS of the errors that are not bad, px. */
  double
  rms() const;

  std::size_t
  judged() const
  {
    return judged_;
  }

private:
  std::size_t judged_ = 0;
  std::size_t wrong_ = 0;
  std::vector<double> errors_; // absolute values
};

/** \brief Signed errors by the fractional part of the true disparity: shows if a
 * sub-pixel method prefers some fractions. Bad errors are ignored. */
class FractionErrors {
public:
  static constexpr std::size_t bins = 20;

  void
  add(const DisparityImage& found, const DisparityImage& truth, const PixelMask& mask);

  /** \brief Standard deviation of the means of the bins, px. */
  double
  lockingOfMeans() const;

  double
  lockingOfMedians() const;

private:
  std::vector<std::vector<double>> errors_ = std::vector<std::vector<double>>(bins);
};

/** \brief Checks the estimated standard deviations. Bad errors are ignored. */
class SigmaErrors {
public:
  void
  add(const DisparityImage& found,
      const std::vector<float>& sigma,
      const DisparityImage& truth,
      const PixelMask& mask);

  /** \brief RMS of error / sigma: 1 if the standard deviations are correct. */
  double
  ratio() const;

  /** \brief Mean standard deviation, px. */
  double
  meanSigma() const;

private:
  std::size_t count_ = 0;
  double squares_ = 0;
  double sigmas_ = 0;
};

} // namespace pcl::acmap::bench
