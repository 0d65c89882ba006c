#pragma once

#include "patch_places.h"

namespace pcl::acmap {

/** \brief The best of some scores; of equal ones the first. */
struct BestScore {
  std::int32_t index = -1;
  std::int32_t score = no_score;
};

BestScore
bestOf(const std::int32_t* scores, std::size_t size);

/** \brief The best score farther than a distance from a patch. */
std::int32_t
bestElsewhere(const std::int32_t* scores,
              const PatchPlaces& places,
              std::size_t from,
              float distance);

/** \brief The best row of each column, whatever the order in which rows are told. */
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
