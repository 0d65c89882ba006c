#pragma once

#include "patch_places.h"

namespace pcl::acmap {

/** \brief The best one of some scores; the first one of equal scores. */
struct BestScore {
  std::int32_t index = -1;
  std::int32_t score = no_score;
};

BestScore
bestOf(const std::int32_t* scores, std::size_t size);

/** \brief The best score of the patches that are farther than \a distance (pixels) from
 * patch \a from. */
std::int32_t
bestElsewhere(const std::int32_t* scores,
              const PatchPlaces& places,
              std::size_t from,
              float distance);

/** \brief The best row of each column, independently of the order in which rows are
 * added. */
class ColumnBests {
public:
  explicit ColumnBests(std::size_t columns)
  : scores_(columns, no_score)
  , rows_(columns, -1)
  {}

  void
  add(std::int32_t row, const std::int32_t* scores);

  void
  add(const ColumnBests& others);

  std::int32_t
  rowOf(std::size_t column) const
  {
    return rows_[column];
  }

private:
  std::vector<std::int32_t> scores_, rows_;
};

} // namespace pcl::acmap
