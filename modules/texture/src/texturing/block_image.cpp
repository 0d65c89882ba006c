#include "texturing/block_image.h"

namespace pcl::acmap::texturing {

BlockImage
halved(const BlockImage& fine)
{
  BlockImage coarse;
  coarse.cover({Eigen::Vector2i(fine.left / 2, fine.top / 2),
                Eigen::Vector2i((fine.left + fine.width - 1) / 2,
                                (fine.top + fine.height - 1) / 2)});
  for (std::int32_t row = coarse.top; row < coarse.top + coarse.height; ++row)
    for (std::int32_t column = coarse.left; column < coarse.left + coarse.width;
         ++column) {
      float sum = 0;
      int count = 0;
      for (const std::int32_t r : {2 * row, 2 * row + 1})
        for (const std::int32_t c : {2 * column, 2 * column + 1})
          if (const float value = fine.at(c, r); !std::isnan(value)) {
            sum += value;
            ++count;
          }
      if (count > 1)
        coarse(column, row) = sum / static_cast<float>(count);
    }
  return coarse;
}

} // namespace pcl::acmap::texturing
