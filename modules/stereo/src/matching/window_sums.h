#pragma once

#include "recipe.h"
#include "shot_stack.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Means and norms of the square window around each pixel, over all shots. */
class WindowSums {
public:
  /** \param[in] behind number of pixels behind the end of a row that can be read */
  WindowSums(const ShotStack& stack, const MatchingRecipe& recipe, int behind);

  WindowRow
  row(int y, int x) const
  {
    const std::int64_t at = static_cast<std::int64_t>(y) * stride_ + x;
    return {means_.data() + at, inverse_norms_.data() + at};
  }

private:
  void
  fillRow(const ShotStack& stack, const MatchingRecipe& recipe, int y);

  int stride_;
  std::vector<float> means_;
  std::vector<float> inverse_norms_;
};

} // namespace pcl::acmap
