#include "texturing/view_selection.h"

#include "texturing/minimum_cut.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::acmap::texturing {

namespace {

/** Costs are in this part of a level of 255. */
constexpr double cost_unit = 1.0 / 16;

std::int64_t
toCost(double levels)
{
  return std::llround(levels / cost_unit);
}

const Sample*
sampleOf(const Canvas::Samples& samples, std::int32_t view)
{
  for (const Sample& sample : samples)
    if (sample.weight > 0 && sample.view == view)
      return &sample;
  return nullptr;
}

Eigen::Array3f
colorOf(const Sample& sample, const std::vector<double>& gains)
{
  const auto gain = static_cast<float>(gains[static_cast<std::size_t>(sample.view)]);
  return gain * Eigen::Array3f(sample.color[0], sample.color[1], sample.color[2]);
}

/** What a view shows of a tile. */
struct Shown {
  std::int32_t texels = 0;
  double lost = 0;  ///< how much smaller the texels are in its image, octaves
  double steps = 0; ///< between neighbouring texels
  Eigen::Array3f less_than_mean{0, 0, 0};
};

} // namespace

template <typename Function>
void
TileViews::forTexels(std::int32_t tile_column,
                     std::int32_t tile_row,
                     Function&& function) const
{
  const std::int32_t right = std::min((tile_column + 1) * side, sheet_.width());
  const std::int32_t bottom = std::min((tile_row + 1) * side, sheet_.height());
  for (std::int32_t row = tile_row * side; row < bottom; ++row)
    for (std::int32_t column = tile_column * side; column < right; ++column)
      function(column, row);
}

TileViews::TileViews(const Sheet& sheet,
                     const std::vector<TexturePicture*>& means,
                     const std::vector<double>& gains)
: sheet_(sheet)
, gains_(gains)
, columns_((sheet.width() + side - 1) / side)
, rows_((sheet.height() + side - 1) / side)
, tiles_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_))
{
  oneapi::tbb::parallel_for(std::int32_t{0}, rows_, [&](std::int32_t row) {
    for (std::int32_t column = 0; column < columns_; ++column)
      measure(column, row, means);
    pollRun();
  });
  std::map<std::int32_t, std::vector<std::size_t>> tiles_of_views;
  for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
    for (const Candidate& candidate : tiles_[tile].candidates)
      tiles_of_views[candidate.view].push_back(tile);
  constexpr int max_rounds = 3;
  bool is_better = tiles_of_views.size() > 1;
  for (int round = 0; round < max_rounds && is_better; ++round) {
    is_better = false;
    for (const auto& [view, tiles] : tiles_of_views) {
      is_better = expand(view, tiles) || is_better;
      pollRun();
    }
  }
}

void
TileViews::measure(std::int32_t tile_column,
                   std::int32_t tile_row,
                   const std::vector<TexturePicture*>& means)
{
  constexpr double of_missing = 24, of_octave = 1.5, of_blur = 2; // levels a texel
  constexpr double free_deviation = 6, of_deviation = 2, max_deviation = 60;
  constexpr double plain = 1.5; // levels: such steps are noise
  std::map<std::int32_t, Shown> shown;
  std::int32_t seen = 0;
  forTexels(tile_column, tile_row, [&](std::int32_t column, std::int32_t row) {
    const Sheet::Place place = sheet_.placeOf(column, row);
    const Canvas::Samples& samples = sheet_.samplesOf(place);
    if (!(samples.front().weight > 0))
      return;
    ++seen;
    const std::uint8_t* const mean =
        &means[place.canvas]->colors.values[3 * place.texel];
    const Canvas::Samples* const next =
        column + 1 < sheet_.width() ? &sheet_.samplesOf(sheet_.placeOf(column + 1, row))
                                    : nullptr;
    for (const Sample& sample : samples) {
      if (!(sample.weight > 0))
        break;
      Shown& one = shown[sample.view];
      const Eigen::Array3f color = colorOf(sample, gains_);
      ++one.texels;
      one.lost += std::log2(samples.front().weight / sample.weight);
      one.less_than_mean += Eigen::Array3f(mean[0], mean[1], mean[2]) - color;
      if (const Sample* const beside = next ? sampleOf(*next, sample.view) : nullptr)
        one.steps +=
            static_cast<double>((colorOf(*beside, gains_) - color).abs().mean());
    }
  });
  std::int32_t most = 0;
  double most_steps = plain;
  for (const auto& [view, one] : shown) {
    most = std::max(most, one.texels);
    most_steps = std::max(most_steps, one.steps / one.texels);
  }
  Tile& tile = tiles_[tileAt(tile_column, tile_row)];
  for (const auto& [view, one] : shown) {
    if (2 * one.texels < most)
      continue;
    Candidate candidate;
    candidate.view = view;
    candidate.texels = one.texels;
    candidate.to_mean = one.less_than_mean / static_cast<float>(one.texels);
    const double deviation = static_cast<double>(candidate.to_mean.abs().maxCoeff());
    const double levels =
        of_missing * (seen - one.texels) + of_octave * one.lost +
        one.texels * of_blur *
            (1 - std::max(one.steps / one.texels, plain) / most_steps) +
        one.texels * of_deviation *
            std::clamp(deviation - free_deviation, 0.0, max_deviation);
    candidate.cost = toCost(levels);
    if (tile.chosen < 0 ||
        candidate.cost < tile.candidates[static_cast<std::size_t>(tile.chosen)].cost)
      tile.chosen = static_cast<std::int32_t>(tile.candidates.size());
    tile.candidates.push_back(candidate);
  }
}

const Candidate*
TileViews::find(const Tile& tile, std::int32_t view) const
{
  for (const Candidate& candidate : tile.candidates)
    if (candidate.view == view)
      return &candidate;
  return nullptr;
}

std::int64_t
TileViews::seamCost(std::size_t first,
                    std::size_t second,
                    std::int32_t a,
                    std::int32_t b) const
{
  constexpr float of_missing = 15, maximum = 60; // levels
  if (a == b)
    return 0;
  const bool is_beside = second == first + 1;
  const auto tile_column =
      static_cast<std::int32_t>(first % static_cast<std::size_t>(columns_));
  const auto tile_row =
      static_cast<std::int32_t>(first / static_cast<std::size_t>(columns_));
  const std::int32_t length = is_beside
                                  ? std::min(side, sheet_.height() - tile_row * side)
                                  : std::min(side, sheet_.width() - tile_column * side);
  float levels = 0;
  for (const std::int32_t across : {side - 1, side}) {
    const Tile& tile = tiles_[across < side ? first : second];
    const Candidate* const of_a = find(tile, a);
    const Candidate* const of_b = find(tile, b);
    for (std::int32_t along = 0; along < length; ++along) {
      const Canvas::Samples& samples = sheet_.samplesOf(
          sheet_.placeOf(tile_column * side + (is_beside ? across : along),
                         tile_row * side + (is_beside ? along : across)));
      if (!(samples.front().weight > 0))
        continue;
      const Sample* const in_a = of_a ? sampleOf(samples, a) : nullptr;
      const Sample* const in_b = of_b ? sampleOf(samples, b) : nullptr;
      levels += in_a && in_b ? std::min(maximum,
                                        (colorOf(*in_a, gains_) + of_a->to_mean -
                                         colorOf(*in_b, gains_) - of_b->to_mean)
                                            .abs()
                                            .mean())
                             : of_missing;
    }
  }
  return toCost(static_cast<double>(levels));
}

bool
TileViews::expand(std::int32_t view, const std::vector<std::size_t>& tiles)
{
  std::vector<std::size_t> moving;
  std::map<std::size_t, std::size_t> node_of;
  for (const std::size_t tile : tiles)
    if (chosenView(tiles_[tile]) != view) {
      node_of.emplace(tile, moving.size());
      moving.push_back(tile);
    }
  if (moving.empty())
    return false;
  MinimumCut cut(moving.size());
  const auto add = [&](std::size_t first, std::size_t second) {
    const std::int32_t a = chosenView(tiles_[first]), b = chosenView(tiles_[second]);
    if (a < 0 || b < 0)
      return;
    const auto of_first = node_of.find(first), of_second = node_of.find(second);
    const bool moves = of_first != node_of.end(),
               other_moves = of_second != node_of.end();
    const std::int64_t kept = seamCost(first, second, a, b);
    const std::int64_t first_moved = moves ? seamCost(first, second, view, b) : 0;
    const std::int64_t second_moved =
        other_moves ? seamCost(first, second, a, view) : 0;
    if (moves && other_moves)
      cut.addPair(
          of_first->second, of_second->second, kept, second_moved, first_moved, 0);
    else if (moves)
      cut.add(of_first->second, kept, first_moved);
    else
      cut.add(of_second->second, kept, second_moved);
  };
  for (std::size_t node = 0; node < moving.size(); ++node) {
    const std::size_t tile = moving[node];
    const Tile& here = tiles_[tile];
    cut.add(node,
            here.candidates[static_cast<std::size_t>(here.chosen)].cost,
            find(here, view)->cost);
    const std::size_t column = tile % static_cast<std::size_t>(columns_);
    if (column + 1 < static_cast<std::size_t>(columns_))
      add(tile, tile + 1);
    if (tile + static_cast<std::size_t>(columns_) < tiles_.size())
      add(tile, tile + static_cast<std::size_t>(columns_));
    if (column > 0 && node_of.count(tile - 1) == 0)
      add(tile - 1, tile);
    if (tile >= static_cast<std::size_t>(columns_) &&
        node_of.count(tile - static_cast<std::size_t>(columns_)) == 0)
      add(tile - static_cast<std::size_t>(columns_), tile);
  }
  bool has_moved = false;
  const std::vector<bool> moved = cut.solve();
  for (std::size_t node = 0; node < moving.size(); ++node)
    if (moved[node]) {
      Tile& tile = tiles_[moving[node]];
      tile.chosen =
          static_cast<std::int32_t>(find(tile, view) - tile.candidates.data());
      has_moved = true;
    }
  return has_moved;
}

/** Between the middles of the four tiles around a texel; tiles without the view do not count. */
Eigen::Array3f
TileViews::offsetAt(std::int32_t column, std::int32_t row, std::int32_t view) const
{
  const float x = (static_cast<float>(column) + 0.5F) / side - 0.5F;
  const float y = (static_cast<float>(row) + 0.5F) / side - 0.5F;
  const auto left = static_cast<std::int32_t>(std::floor(x));
  const auto top = static_cast<std::int32_t>(std::floor(y));
  Eigen::Array3f sum = Eigen::Array3f::Zero();
  float weights = 0;
  for (std::int32_t r = std::max(top, 0); r <= std::min(top + 1, rows_ - 1); ++r)
    for (std::int32_t c = std::max(left, 0); c <= std::min(left + 1, columns_ - 1); ++c)
      if (const Candidate* const candidate = find(tiles_[tileAt(c, r)], view)) {
        const float weight = (1 - std::abs(x - static_cast<float>(c))) *
                             (1 - std::abs(y - static_cast<float>(r)));
        weights += weight;
        sum += weight * candidate->to_mean;
      }
  return weights > 0 ? Eigen::Array3f(sum / weights) : sum;
}

void
TileViews::paint(const std::vector<TexturePicture*>& pictures) const
{
  const auto paintTile = [&](std::int32_t tile_column, std::int32_t tile_row) {
    std::vector<std::int32_t> views; // of the tile, then of those around it
    for (const auto& [right, down] :
         {std::pair(0, 0), {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const std::int32_t c = tile_column + right, r = tile_row + down;
      if (c >= 0 && r >= 0 && c < columns_ && r < rows_)
        if (const std::int32_t view = chosenView(tiles_[tileAt(c, r)]); view >= 0)
          views.push_back(view);
    }
    forTexels(tile_column, tile_row, [&](std::int32_t column, std::int32_t row) {
      const Sheet::Place place = sheet_.placeOf(column, row);
      const Canvas::Samples& samples = sheet_.samplesOf(place);
      const Sample* sample = nullptr;
      for (std::size_t i = 0; i < views.size() && !sample; ++i)
        sample = sampleOf(samples, views[i]);
      if (!sample)
        return;
      const Eigen::Array3f color =
          colorOf(*sample, gains_) + offsetAt(column, row, sample->view);
      std::uint8_t* const target =
          &pictures[place.canvas]->colors.values[3 * place.texel];
      for (Eigen::Index k = 0; k < 3; ++k)
        target[k] =
            static_cast<std::uint8_t>(std::lround(std::clamp(color[k], 0.0F, 255.0F)));
    });
  };
  oneapi::tbb::parallel_for(std::int32_t{0}, rows_, [&](std::int32_t row) {
    for (std::int32_t column = 0; column < columns_; ++column)
      paintTile(column, row);
  });
}

} // namespace pcl::acmap::texturing
