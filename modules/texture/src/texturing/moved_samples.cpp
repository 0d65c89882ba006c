#include "texturing/moved_samples.h"

#include "texturing/sheet_plane.h"

#include <pcl/core/impl/parallel.h>

#include <cmath>
#include <optional>

namespace pcl::acmap::texturing {

namespace {

const Sample*
seenBy(std::int32_t view, const Canvas::Samples& samples)
{
  for (const Sample& sample : samples)
    if (sample.weight > 0 && sample.view == view)
      return &sample;
  return nullptr;
}

/** Bilinear between the samples of a view; nothing if it has not seen the texel there. */
std::optional<std::array<std::uint8_t, 3>>
colorBetween(const Sheet& sheet, std::int32_t view, const Eigen::Vector2d& place)
{
  const double left = place.x() - 0.5, top = place.y() - 0.5;
  if (!(left > -1 && top > -1 && left < sheet.width() && top < sheet.height()))
    return std::nullopt;
  const double column = std::floor(left), row = std::floor(top);
  const double x = left - column, y = top - row;
  std::array<double, 3> sums{};
  double shares = 0;
  for (const int r : {0, 1})
    for (const int c : {0, 1}) {
      const Eigen::Vector2i texel(static_cast<int>(column) + c,
                                  static_cast<int>(row) + r);
      if (texel.minCoeff() < 0 || texel.x() >= sheet.width() ||
          texel.y() >= sheet.height())
        continue;
      const Sample* const sample =
          seenBy(view, sheet.samplesOf(sheet.placeOf(texel.x(), texel.y())));
      if (!sample)
        continue;
      const double own = (c ? x : 1 - x) * (r ? y : 1 - y);
      shares += own;
      for (std::size_t k = 0; k < 3; ++k)
        sums[k] += own * sample->color[k];
    }
  if (!(shares > 0.5))
    return std::nullopt;
  std::array<std::uint8_t, 3> color;
  for (std::size_t k = 0; k < 3; ++k)
    color[k] = static_cast<std::uint8_t>(std::lround(sums[k] / shares));
  return color;
}

/** The samples of a texel after the cameras were moved.
 * \param[in] sources of each view (\ref SheetPlane::sourceOf, of single texels) */
Canvas::Samples
movedSamples(const Sheet& sheet,
             std::int32_t column,
             std::int32_t row,
             const std::vector<Eigen::Matrix3d>& sources)
{
  Canvas::Samples result{};
  std::size_t count = 0;
  const Eigen::Vector3d place(column + 0.5, row + 0.5, 1);
  for (const Sample& sample : sheet.samplesOf(sheet.placeOf(column, row))) {
    if (!(sample.weight > 0))
      break;
    const Eigen::Vector2d source =
        (sources[static_cast<std::size_t>(sample.view)] * place).hnormalized();
    if (const auto color = colorBetween(sheet, sample.view, source))
      result[count++] = {sample.weight, sample.view, *color};
  }
  return result;
}

} // namespace

void
moveSamples(const std::vector<Eigen::Isometry3d>& moves,
            const std::vector<Eigen::Vector3d>& eyes,
            const std::vector<Sheet>& sheets,
            std::vector<Canvas>& canvases)
{
  for (const Sheet& sheet : sheets) {
    const Canvas& first = canvases[sheet.begin()];
    if (!first.surface.plane())
      continue;
    const SheetPlane surface(first, sheet);
    std::vector<Eigen::Matrix3d> sources;
    for (std::size_t view = 0; view < moves.size(); ++view)
      sources.push_back(surface.sourceOf(eyes[view], moves[view].inverse(), 1));
    std::vector<LargeVector<Canvas::Samples>> moved;
    for (std::size_t c = sheet.begin(); c < sheet.end(); ++c)
      moved.emplace_back(canvases[c].samples.size());
    oneapi::tbb::parallel_for(std::int32_t{0}, sheet.height(), [&](std::int32_t row) {
      for (std::int32_t column = 0; column < sheet.width(); ++column) {
        const Sheet::Place at = sheet.placeOf(column, row);
        moved[at.canvas - sheet.begin()][at.texel] =
            movedSamples(sheet, column, row, sources);
      }
    });
    for (std::size_t c = sheet.begin(); c < sheet.end(); ++c)
      canvases[c].samples = std::move(moved[c - sheet.begin()]);
  }
}

} // namespace pcl::acmap::texturing
