#pragma once

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

/** \brief Weights of points as integers, at most 2^15, so that their sums do not depend
 * on the order. */
class PointWeights {
public:
  /** \param[in] weights one per point; nullptr: 1 each
   * \param[in] largest upper limit of the weights */
  PointWeights(const float* weights, float largest);

  std::uint64_t
  operator[](std::size_t i) const
  {
    return weights_ ? static_cast<std::uint64_t>(
                          static_cast<double>(weights_[i]) * scale_ + 0.5)
                    : one_;
  }

  /** \brief The weight that the integer 1 represents. */
  double
  unit() const
  {
    return unit_;
  }

private:
  const float* weights_;
  double scale_, unit_;
  std::uint64_t one_; ///< used if there are no weights
};

/** \brief Returns the largest weight, 1 for nullptr.
 * \throws BadArgumentException naming the first one that is negative or not finite */
float
largestWeight(const float* weights, std::size_t size);

} // namespace pcl::acmap
