#pragma once

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

/** \brief Weights of points as integers, at most 2^15, so that no order of
 * their sums matters. */
class PointWeights {
public:
  /** \param[in] weights one a point; nullptr: 1 each
   * \param[in] largest no weight is larger */
  PointWeights(const float* weights, float largest);

  std::uint64_t
  operator[](std::size_t i) const
  {
    return weights_ ? static_cast<std::uint64_t>(
                          static_cast<double>(weights_[i]) * scale_ + 0.5)
                    : one_;
  }

  /** \brief What 1 stands for. */
  double
  unit() const
  {
    return unit_;
  }

private:
  const float* weights_;
  double scale_, unit_;
  std::uint64_t one_; ///< where there are no weights, which may all be tiny
};

/** \brief The largest weight, 1 for nullptr.
 * \throws BadArgumentException naming the first that is negative or not finite */
float
largestWeight(const float* weights, std::size_t size);

} // namespace pcl::acmap
