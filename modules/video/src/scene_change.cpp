#include "scene_change.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace pcl::acmap {

namespace {

constexpr int block_side = 8; // px
constexpr std::size_t blocks_per_exception = 100;

/** \brief Index of the block of a pixel; the last one also has the rest of the row. */
int
blockOf(int pixel, int blocks)
{
  return std::min(pixel / block_side, blocks - 1);
}

int
blocksAlong(int pixels)
{
  return std::max(1, pixels / block_side);
}

} // namespace

double
sceneChange(const CameraImage& before, const CameraImage& after)
{
  if (before.width != after.width || before.height != after.height ||
      before.channels != after.channels || before.values.size() != after.values.size())
    return std::numeric_limits<double>::infinity();
  if (after.empty())
    return 0;
  struct Block {
    long change = 0;
    long values = 0;
  };
  const int columns = blocksAlong(after.width);
  const int rows = blocksAlong(after.height);
  std::vector<Block> blocks(static_cast<std::size_t>(columns) *
                            static_cast<std::size_t>(rows));
  std::size_t i = 0;
  for (int y = 0; y < after.height; ++y)
    for (int x = 0; x < after.width; ++x) {
      Block& block = blocks[static_cast<std::size_t>(blockOf(y, rows) * columns +
                                                     blockOf(x, columns))];
      for (int channel = 0; channel < after.channels; ++channel, ++i)
        block.change += after.values[i] - before.values[i];
      block.values += after.channels;
    }
  std::vector<double> changes;
  for (const Block& block : blocks)
    changes.push_back(std::abs(static_cast<double>(block.change) /
                               static_cast<double>(block.values)));
  const auto place = changes.begin() +
                     static_cast<std::ptrdiff_t>(changes.size() / blocks_per_exception);
  std::nth_element(changes.begin(), place, changes.end(), std::greater<>());
  return *place;
}

} // namespace pcl::acmap
