#include "texturing/splatter.h"

#include "texturing/view_colors.h"

#include <vector>

namespace pcl::acmap::texturing {
namespace {

struct Mean {
  std::uint64_t count = 0;
  std::array<std::uint64_t, 3> sums{};
};

/** Indices of the points of one canvas, in ascending order. */
using Points = std::vector<std::size_t>;

void
splatOnto(const ColoredView& view,
          std::int32_t number,
          const Points& points,
          Canvas& canvas)
{
  std::vector<Mean> means(canvas.mask.size());
  for (const std::size_t i : points) {
    const Eigen::Vector2d place =
        placeOn(canvas.chart, view.T_map_camera * view.points[i].cast<double>());
    const std::size_t texel = canvas.index(static_cast<std::int32_t>(place.x()),
                                           static_cast<std::int32_t>(place.y()));
    if (canvas.mask[texel] != TexelPlace::Inside)
      continue;
    ++means[texel].count;
    const Rgb color = colorOf(view, i);
    for (std::size_t k = 0; k < 3; ++k)
      means[texel].sums[k] += color[k];
  }
  for (std::size_t t = 0; t < means.size(); ++t) {
    const Mean& mean = means[t];
    if (mean.count == 0)
      continue;
    Sample sample{static_cast<float>(mean.count), number, {}};
    for (std::size_t k = 0; k < 3; ++k)
      sample.color[k] =
          static_cast<std::uint8_t>((mean.sums[k] + mean.count / 2) / mean.count);
    canvas.offer(t, sample);
  }
}

} // namespace

void
splat(const ColoredView& view,
      std::int32_t number,
      const std::vector<std::int32_t>& nearest,
      std::vector<Canvas>& canvases)
{
  std::vector<Points> points(canvases.size());
  for (std::size_t i = 0; i < nearest.size(); ++i)
    if (nearest[i] >= 0)
      points[static_cast<std::size_t>(nearest[i])].push_back(i);
  for (std::size_t c = 0; c < canvases.size(); ++c)
    if (!points[c].empty())
      splatOnto(view, number, points[c], canvases[c]);
}

} // namespace pcl::acmap::texturing
