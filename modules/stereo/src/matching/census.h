#pragma once

#include "shot_stack.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief For each pixel of a shot, one bit per neighbour and difference: is the
 * neighbour brighter by more than the difference? The census of Zabih and Woodfill
 * (1994) has only the difference 0. Small differences are compared in 9 x 7 pixels,
 * larger ones in 5 x 5: the wide window localizes pixels between few lines, the narrow
 * one preserves edges. */
class Census {
public:
  /** \param[in] behind number of pixels behind the end of a row that can be read */
  Census(const ShotStack& shot, int behind);

  ShotRows<std::uint64_t>
  row(int y, int x = 0) const
  {
    return {bits_.data() + static_cast<std::int64_t>(y) * stride_ + x, plane_, words};
  }

  static constexpr int words = 4; ///< each has one bit per neighbour

private:
  int stride_;
  std::int64_t plane_;
  std::vector<std::uint64_t> bits_;
};

} // namespace pcl::acmap
