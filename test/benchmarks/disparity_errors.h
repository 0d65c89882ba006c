#pragma once

#include "stereo_input.h"

#include <cstddef>
#include <vector>

namespace pcl::acmap::bench {

/** \brief How disparities differ from the truth; several images may be added up. */
class DisparityErrors {
public:
  /** \brief An error above this is bad, px. */
  static constexpr double bad_error = 1.0;

  /** \brief Holds an image against the truth at the pixels of a mask; they must have one.
   */
  void
  add(const DisparityImage& found, const DisparityImage& truth, const PixelMask& mask);

  /** \brief Percent of the pixels judged that are bad or have no disparity. */
  double
  bad() const;

  /** \brief Percent of the pixels judged that have a disparity, right or wrong. */
  double
  present() const;

  /** \brief Percent of the pixels judged that have a bad one. */
  double
  wrong() const;

  /** \brief Median of the unsigned errors of all disparities, px. */
  double
  medianError() const;

  /** \brief Root mean square of the errors that are not bad, px. */
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
  std::vector<double> errors_; // unsigned
};

/** \brief Signed errors by the fraction of the true disparity: what a sub-pixel method
 * that prefers some fractions shows. Bad errors are left out. */
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

  /** \brief Standard deviation over the bins of their means, px. */
  double
  lockingOfMeans() const;

  double
  lockingOfMedians() const;

private:
  std::vector<std::vector<double>> errors_ = std::vector<std::vector<double>>(bins);
};

/** \brief How honest standard deviations are. Bad errors are left out. */
class SigmaErrors {
public:
  void
  add(const DisparityImage& found,
      const std::vector<float>& sigma,
      const DisparityImage& truth,
      const PixelMask& mask);

  /** \brief Root mean square of error / sigma: 1 where they are honest. */
  double
  ratio() const;

  /** \brief px. */
  double
  meanSigma() const;

private:
  std::size_t count_ = 0;
  double squares_ = 0;
  double sigmas_ = 0;
};

} // namespace pcl::acmap::bench
