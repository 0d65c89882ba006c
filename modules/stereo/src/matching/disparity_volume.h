#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief One value per pixel and disparity.
 * \tparam Row of these values, with its width and stride */
template <typename Value, typename Row>
struct DisparityVolume {
  int width = 0;
  int height = 0;
  int stride = 0;
  std::vector<Value> values;

  void
  resize(int new_width, int new_height, int new_stride)
  {
    width = new_width;
    height = new_height;
    stride = new_stride;
    values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                  static_cast<std::size_t>(stride));
  }

  const Value*
  at(int x, int y) const
  {
    return values.data() + (static_cast<std::int64_t>(y) * width + x) * stride;
  }

  Row
  row(int y)
  {
    return {
        values.data() + static_cast<std::int64_t>(y) * width * stride, width, stride};
  }
};

} // namespace pcl::acmap
