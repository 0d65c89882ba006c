#pragma once

#include "pair_costs.h"
#include "pair_winners.h"

#include <vector>

namespace pcl::acmap {

/** \brief Sums over the shots for the pixels of one row, at whole pixels around the
 * winner, and for the neighbour's row at quarter pixels. */
class QuarterSums {
public:
  /** \param[in] centred as in \ref MatchingRecipe */
  void
  fill(const ShotStack& reference,
       const ShotStack& target,
       const PairWinners& winners,
       const DisparityRange& range,
       bool centred,
       int y);

  /** \brief The sums; valid until the next call of \ref fill. */
  const MatchedRow&
  row() const
  {
    return row_;
  }

  bool
  isInside(int x) const
  {
    return row_.shifts[x] != MatchedRow::outside;
  }

  /** \brief ZNCC of the levels of a pixel over time.
   * \param[in] place quarter pixels from the winner, at most 3
   * \param[in] floor is added to both sums of squares */
  float
  ownCorrelation(int x, int place, float floor) const;

private:
  void
  findShifts(const PairWinners& winners, const DisparityRange& range, int y);
  void
  sumShots(bool values);

  int width_ = 0;
  int shots_ = 0;
  MatchedRow row_{};
  std::vector<int> shifts_, least_, greatest_;
  std::vector<float> levels_;        // of the reference, by shot
  std::vector<float> target_levels_; // of the neighbour, by shot
  std::vector<float> products_;
  std::vector<float> products_of_five_;
  std::vector<float> sums_[4]; // of the reference, as in LevelSums
  std::vector<float> target_sums_[4];
};

} // namespace pcl::acmap
