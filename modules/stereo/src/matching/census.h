#pragma once

#include "shot_stack.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief For each pixel of a shot, bits for its neighbours: whether each is brighter by more
 * than a difference, for several differences (the census of Zabih and Woodfill, 1994, which
 * knows one, 0). Small differences count in 9 x 7 pixels, larger ones in 5 x 5: the wide
 * window finds its place among few lines, the narrow one keeps edges. */
class Census {
public:
  /** \param[in] behind pixels to be read behind the end of a row */
  Census(const ShotStack& shot, int behind);

  ShotRows<std::uint64_t>
  row(int y, int x = 0) const
  {
    return {bits_.data() + static_cast<std::int64_t>(y) * stride_ + x, plane_, words};
  }

  static constexpr int words = 4; ///< a bit of each, for each neighbour

private:
  int stride_;
  std::int64_t plane_;
  std::vector<std::uint64_t> bits_;
};

} // namespace pcl::acmap
