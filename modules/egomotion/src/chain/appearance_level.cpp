#include "chain/appearance_level.h"

#include <pcl/core/impl/parallel.h>

namespace pcl::acmap {

namespace {

std::vector<Eigen::Vector2f>
gradientsOf(const AppearanceLevel& level)
{
  std::vector<Eigen::Vector2f> gradients(level.values.size(), Eigen::Vector2f::Zero());
  const auto value = [&](int x, int y) {
    return level.values[pixelAt(level.width, x, y)];
  };
  oneapi::tbb::parallel_for(1, level.height - 1, [&](int y) {
    for (int x = 1; x + 1 < level.width; ++x)
      gradients[pixelAt(level.width, x, y)] = {(value(x + 1, y) - value(x - 1, y)) / 2,
                                               (value(x, y + 1) - value(x, y - 1)) / 2};
  });
  return gradients;
}

} // namespace

AppearanceLevel
appearanceLevel(const ViewLevel& view)
{
  AppearanceLevel level;
  level.width = view.image.width;
  level.height = view.image.height;
  level.scale = view.scale;
  level.noise = view.noise;
  level.values = view.image.values;
  level.gradients = gradientsOf(level);
  level.points = view.points;
  return level;
}

} // namespace pcl::acmap
