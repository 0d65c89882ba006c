#pragma once

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

/** Lengths of descriptions in bits, at the resolution that the noise allows: heights
 * are told to a quarter of sigma, and parameters to what the elements determine. */
class DescriptionLength {
public:
  static constexpr double label = 24; ///< of a model

  /** \param[in] sigma of the elements, metres, above 0
   * \param[in] spacing of the elements, metres
   * \param[in] extent of the scene, metres */
  DescriptionLength(double sigma, double spacing, double extent)
  : sigma_(sigma)
  , extent_(extent)
  , free_(std::log2(std::max(8.0, 2 * spacing / sigma)) + 2)
  {}

  /** The height of an element above its neighbours. */
  double
  freeElement() const
  {
    return free_;
  }

  /** An element at an offset from its model; never more than a free one. */
  double
  element(double offset) const
  {
    // log2 (4 sqrt (2 pi)): a normal distribution, told to a quarter of sigma
    constexpr double of_noise = 3.3257480647361593, log2_of_e = 1.4426950408889634;
    const double ratio = offset / sigma_;
    return std::min(free_, of_noise + ratio * ratio / 2 * log2_of_e);
  }

  /** A parameter, to the accuracy that the elements give it. */
  double
  parameter(double elements) const
  {
    return std::log2(std::max(2.0, extent_ / sigma_ / elements)) +
           0.5 * std::log2(std::max(elements, 1.0));
  }

  /** Lengths in an outline. */
  double
  outline(int lengths) const
  {
    return lengths * std::log2(std::max(2.0, extent_ / sigma_));
  }

  /** A model with its label and an outline of four corners. */
  double
  model(int parameters, double elements) const
  {
    return parameters * parameter(elements) + label + outline(4);
  }

  double
  plane(double elements) const
  {
    return model(3, elements);
  }

  double
  cylinder(double elements) const
  {
    return model(5, elements);
  }

private:
  double sigma_;
  double extent_;
  double free_;
};

} // namespace pcl::acmap
