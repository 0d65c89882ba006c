#include "texturing/splatter.h"

#include "texturing/view_colors.h"

#include <map>

namespace pcl::acmap::texturing {
namespace {

struct Mean {
  std::uint64_t count = 0;
  std::array<std::uint64_t, 3> sums{};
};

} // namespace

void
splat(const ColoredView& view,
      std::int32_t number,
      const std::vector<std::int32_t>& nearest,
      std::vector<Canvas>& canvases)
{
  std::map<std::int32_t, std::vector<Mean>> means;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    if (nearest[i] < 0)
      continue;
    const Canvas& canvas = canvases[static_cast<std::size_t>(nearest[i])];
    std::vector<Mean>& texels = means[nearest[i]];
    texels.resize(canvas.mask.size());
    const Eigen::Vector2d place =
        placeOn(canvas.chart, view.T_map_camera * view.points[i].cast<double>());
    const std::size_t texel = canvas.index(static_cast<std::int32_t>(place.x()),
                                           static_cast<std::int32_t>(place.y()));
    if (canvas.mask[texel] != TexelPlace::Inside)
      continue;
    Mean& mean = texels[texel];
    ++mean.count;
    const Rgb color = colorOf(view, i);
    for (std::size_t k = 0; k < 3; ++k)
      mean.sums[k] += color[k];
  }
  for (const auto& [c, texels] : means)
    for (std::size_t t = 0; t < texels.size(); ++t) {
      const Mean& mean = texels[t];
      if (mean.count == 0)
        continue;
      Sample sample{static_cast<float>(mean.count), number, {}};
      for (std::size_t k = 0; k < 3; ++k)
        sample.color[k] =
            static_cast<std::uint8_t>((mean.sums[k] + mean.count / 2) / mean.count);
      canvases[static_cast<std::size_t>(c)].offer(t, sample);
    }
}

} // namespace pcl::acmap::texturing
