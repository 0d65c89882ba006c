#include "atlas/chart_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::acmap {

namespace {

/** \brief Sums of the colours of a chart over blocks of texels. */
struct PyramidLevel {
  std::int32_t width = 0, height = 0;
  std::vector<Eigen::Array4f> sums; ///< red, green, blue, number of texels

  const Eigen::Array4f&
  at(std::int32_t column, std::int32_t row) const
  {
    return sums[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(column)];
  }
};

/** \brief The picture of a chart in all resolutions, from its own on to one texel. */
class PicturePyramid {
public:
  PicturePyramid(const TexturePicture& chart, const std::vector<bool>& cover)
  {
    PyramidLevel whole{chart.colors.width, chart.colors.height, {}};
    whole.sums.resize(cover.size());
    for (std::size_t i = 0; i < cover.size(); ++i) {
      const std::uint8_t* const color = &chart.colors.values[3 * i];
      if (chart.kinds[i] != TexelKind::None)
        whole.sums[i] = Eigen::Array4f(color[0], color[1], color[2], 1);
      else if (cover[i])
        whole.sums[i] = Eigen::Array4f(unknown_grey, unknown_grey, unknown_grey, 1);
      else
        whole.sums[i].setZero();
    }
    levels_.push_back(std::move(whole));
    while (levels_.back().sums.size() > 1)
      levels_.push_back(halved(levels_.back()));
  }

  std::int32_t
  maxHalvings() const
  {
    return static_cast<std::int32_t>(levels_.size()) - 1;
  }

  /** Is a texel known, or grey because it is not? */
  bool
  isFixed(std::size_t texel) const
  {
    return levels_.front().sums[texel][3] > 0;
  }

  RgbImage
  image(std::int32_t halvings, double exposure) const
  {
    const PyramidLevel& level = levels_[static_cast<std::size_t>(halvings)];
    RgbImage image{level.width, level.height, {}};
    image.values.reserve(3 * level.sums.size());
    for (std::int32_t row = 0; row < level.height; ++row)
      for (std::int32_t column = 0; column < level.width; ++column) {
        const Eigen::Array3f color = colorAt(halvings, column, row);
        for (const Eigen::Index k : {0, 1, 2})
          image.values.push_back(exposed(static_cast<double>(color[k]), exposure));
      }
    return image;
  }

private:
  static PyramidLevel
  halved(const PyramidLevel& fine)
  {
    PyramidLevel coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
    for (std::int32_t row = 0; row < coarse.height; ++row)
      for (std::int32_t column = 0; column < coarse.width; ++column) {
        Eigen::Array4f sum = Eigen::Array4f::Zero();
        for (std::int32_t r = 2 * row; r < std::min(2 * row + 2, fine.height); ++r)
          for (std::int32_t c = 2 * column; c < std::min(2 * column + 2, fine.width);
               ++c)
            sum += fine.at(c, r);
        coarse.sums.push_back(sum);
      }
    return coarse;
  }

  /** Mean colour of a block; if none of its texels has a colour, that of the smallest
   * larger block that has one. */
  Eigen::Array3f
  colorAt(std::int32_t halvings, std::int32_t column, std::int32_t row) const
  {
    for (auto level = levels_.begin() + halvings; level != levels_.end(); ++level) {
      const Eigen::Array4f& sum = level->at(column, row);
      if (sum[3] > 0)
        return sum.head<3>() / sum[3];
      column /= 2;
      row /= 2;
    }
    return Eigen::Array3f::Constant(unknown_grey);
  }

  std::vector<PyramidLevel> levels_;
};

/** Does a picture, enlarged, agree with a chart within the tolerance? */
bool
agrees(const TexturePicture& chart,
       const PicturePyramid& pyramid,
       const RgbImage& small,
       std::int32_t halvings,
       const PictureSettings& settings)
{
  constexpr std::int32_t block = 8; // texels
  constexpr double max_local = 3;   // times the tolerance
  constexpr double min_texels = 16; // of a block, so that one texel is no block
  TexturePicture large;
  large.halvings = halvings;
  large.colors.width = chart.colors.width;
  large.colors.height = chart.colors.height;
  enlarge(small, settings.exposure, large);
  const std::int32_t columns = (chart.colors.width + block - 1) / block;
  std::vector<Eigen::Array2d> blocks; // sum of squares, number of texels
  double squares = 0, texels = 0;
  for (std::int32_t row = 0; row < chart.colors.height; ++row) {
    if (row % block == 0)
      blocks.assign(static_cast<std::size_t>(columns), Eigen::Array2d::Zero());
    for (std::int32_t column = 0; column < chart.colors.width; ++column) {
      const std::size_t texel =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(chart.colors.width) +
          static_cast<std::size_t>(column);
      if (!pyramid.isFixed(texel))
        continue;
      const bool is_grey = chart.kinds[texel] == TexelKind::None;
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double own = is_grey ? unknown_grey : chart.colors.values[3 * texel + k];
        square += (large.colors.values[3 * texel + k] - own) *
                  (large.colors.values[3 * texel + k] - own) / 3;
      }
      blocks[static_cast<std::size_t>(column / block)] += Eigen::Array2d(square, 1);
      squares += square;
      ++texels;
    }
    if (row % block != block - 1 && row != chart.colors.height - 1)
      continue;
    const double local = max_local * settings.tolerance;
    for (const Eigen::Array2d& sums : blocks)
      if (sums[0] > local * local * std::max(sums[1], min_texels))
        return false;
  }
  return squares <= settings.tolerance * settings.tolerance * texels;
}

} // namespace

Eigen::Vector2i
halvedSize(const RgbImage& image, std::int32_t halvings)
{
  const auto halved = [&](std::int64_t side) {
    return static_cast<std::int32_t>((side + (std::int64_t{1} << halvings) - 1) >>
                                     halvings);
  };
  return {halved(image.width), halved(image.height)};
}

std::uint8_t
exposed(double value, double exposure)
{
  return static_cast<std::uint8_t>(std::min(255L, std::lround(exposure * value)));
}

void
enlarge(const RgbImage& small, double exposure, TexturePicture& chart)
{
  const auto step = static_cast<double>(std::int64_t{1} << chart.halvings);
  struct Between {
    std::int32_t first, second;
    double share; ///< of the second
  };
  const auto between = [&](std::int32_t i, std::int32_t size) {
    const double place = std::clamp((i + 0.5) / step - 0.5, 0.0, size - 1.0);
    const auto first = static_cast<std::int32_t>(place);
    return Between{first, std::min(first + 1, size - 1), place - first};
  };
  RgbImage& image = chart.colors;
  image.values.clear();
  image.values.reserve(3 * static_cast<std::size_t>(image.width) *
                       static_cast<std::size_t>(image.height));
  std::vector<Between> columns;
  for (std::int32_t column = 0; column < image.width; ++column)
    columns.push_back(between(column, small.width));
  for (std::int32_t row = 0; row < image.height; ++row) {
    const Between y = between(row, small.height);
    for (const Between& x : columns)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto mixed = [&](std::int32_t r) {
          return (1 - x.share) * small.at(x.first, r)[k] +
                 x.share * small.at(x.second, r)[k];
        };
        image.values.push_back(exposed(
            (1 - y.share) * mixed(y.first) + y.share * mixed(y.second), 1 / exposure));
      }
  }
}

ChartPicture
pictureOf(const TexturePicture& chart,
          const std::vector<bool>& cover,
          const PictureSettings& settings)
{
  const PicturePyramid pyramid(chart, cover);
  const std::int32_t last = pyramid.maxHalvings();
  ChartPicture best;
  best.halvings = std::min(settings.min_halvings, last);
  best.image = pyramid.image(best.halvings, settings.exposure);
  const auto takeIfGood = [&](std::int32_t halvings) {
    RgbImage image = pyramid.image(halvings, settings.exposure);
    if (!agrees(chart, pyramid, image, halvings, settings))
      return false;
    best = {halvings, std::move(image)};
    return true;
  };
  if (!(settings.tolerance > 0) || takeIfGood(last))
    return best;
  while (best.halvings + 1 < last && takeIfGood(best.halvings + 1)) {
  }
  return best;
}

} // namespace pcl::acmap
