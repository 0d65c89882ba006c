#pragma once

#include "stereo_input.h"

#include <cstddef>
#include <vector>

namespace pcl::acmap::bench {

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

  /** \brief Mean signed error of a bin, px. */
  double
  meanOf(std::size_t bin) const;

  double
  medianOf(std::size_t bin) const;

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
