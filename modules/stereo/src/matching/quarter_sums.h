#pragma once

#include "pair_costs.h"
#include "pair_winners.h"

#include <vector>

namespace pcl::acmap {

/** \brief Sums over the shots for the pixels of one row, at sixteen quarter pixels
 * starting 2 px before the winner. */
class QuarterSums {
public:
  void
  fill(const ShotStack& reference,
       const ShotStack& target,
       const PairWinners& winners,
       const DisparityRange& range,
       int y);

  /** \brief Sums of the neighbour, by pixel of the row. */
  const SubPixelSums*
  sums() const
  {
    return sums_.data();
  }

  /** \brief Sums of the reference's squares. */
  const float*
  squares() const
  {
    return squares_.data();
  }

  /** \brief Sums of the reference's values. */
  const float*
  values() const
  {
    return values_.data();
  }

  /** \brief Winners; \ref outside if they are outside the neighbour's image. */
  const int*
  winners() const
  {
    return winners_.data();
  }

  static constexpr int outside = 1 << 20;

private:
  void
  interpolate(const ShotStack& target, int y, int length);

  std::vector<SubPixelSums> sums_;
  std::vector<float> squares_;
  std::vector<float> values_;
  std::vector<int> winners_;
  std::vector<float> levels_;   // of the reference, by shot
  std::vector<float> quarters_; // of the neighbour, by shot
};

} // namespace pcl::acmap
