#include "pair_match.h"

#include <cmath>
#include <cstdlib>

namespace pcl::acmap {

namespace {

/** Maps pixels of a transposed or mirrored pair to their indices in the image. */
class PixelPlaces {
public:
  PixelPlaces(const PairLayout& layout, int width, int height)
  : layout_(layout)
  , width_(width)
  , height_(height)
  {}

  std::size_t
  operator()(int x, int y) const
  {
    const int along = layout_.mirrored ? width_ - 1 - x : x;
    return layout_.transposed ? at(y, along, height_) : at(along, y, width_);
  }

private:
  static std::size_t
  at(int column, int row, int width)
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }

  PairLayout layout_;
  int width_, height_;
};

/** Tests matches in the order in which a user would search for the cause. */
class PairJudge {
public:
  PairJudge(const PairWinners& winners,
            const RefinedPair& refined,
            const DisparityRange& range,
            const MatchTests& tests)
  : winners_(winners)
  , refined_(refined)
  , range_(range)
  , tests_(tests)
  {}

  DisparityOutcome
  judge(int x, std::size_t at) const
  {
    if (!std::isfinite(refined_.disparity[at]))
      return DisparityOutcome::OutOfView;
    // A uniformly grey pixel fits anywhere and is rejected with any threshold.
    if (refined_.deviation[at] <= 0.0F || refined_.deviation[at] < tests_.deviation)
      return DisparityOutcome::Untextured;
    if (refined_.correlation[at] < tests_.correlation)
      return DisparityOutcome::Uncorrelated;
    if (tests_.uniqueness > 0 && winners_.uniqueness[at] < tests_.uniqueness)
      return DisparityOutcome::Ambiguous;
    if (tests_.left_right && !isMatchedBack(x, at))
      return DisparityOutcome::OneSided;
    return DisparityOutcome::Matched;
  }

private:
  bool
  isMatchedBack(int x, std::size_t at) const
  {
    const int column = x + range_.first + winners_.index[at];
    const std::size_t row = at - static_cast<std::size_t>(x);
    const int back = winners_.matched_by[row + static_cast<std::size_t>(column)];
    return back >= 0 && std::abs(back - x) <= tests_.left_right_threshold;
  }

  const PairWinners& winners_;
  const RefinedPair& refined_;
  const DisparityRange& range_;
  const MatchTests& tests_;
};

std::uint8_t
inByteUnits(int cost)
{
  return static_cast<std::uint8_t>((cost + byte_cost_unit / 2) / byte_cost_unit);
}

} // namespace

void
PairMatcher::findWinners(const MatchingRecipe& recipe,
                         const DisparityRange& range,
                         bool uniqueness)
{
  if (recipe.cost == PairCost::OverTime) {
    fillTimeCosts(reference_, target_, range, byte_costs_);
    byte_paths_.findWinners(
        range,
        {inByteUnits(recipe.small_penalty), inByteUnits(recipe.large_penalty)},
        uniqueness,
        byte_costs_,
        winners_);
    return;
  }
  fillCosts(reference_, target_, recipe, range, costs_);
  paths_.findWinners(
      reference_,
      range,
      {recipe.small_penalty, recipe.large_penalty, recipe.contrast, uniqueness},
      costs_,
      winners_);
}

void
PairMatcher::match(const PairImages& images,
                   const MatchingRecipe& recipe,
                   const DisparityRange& range,
                   const MatchTests& tests,
                   PairMatch& match)
{
  reference_.read(images.reference, images.layout, recipe.blur, 0);
  target_.read(images.target,
               images.layout,
               recipe.blur,
               range.first + range.stride(byte_block));
  if (recipe.centred) {
    reference_.takeOffMean();
    target_.takeOffMean();
  }
  findWinners(recipe, range, tests.uniqueness > 0);
  refineWinners(reference_, target_, winners_, range, recipe.centred, refined_);

  const int width = reference_.width(), height = reference_.height();
  const PixelPlaces places(images.layout, width, height);
  const PairJudge judge(winners_, refined_, range, tests);
  const std::size_t pixels = refined_.disparity.size();
  match.disparity.resize(pixels);
  match.sigma.resize(pixels);
  match.correlation.resize(pixels);
  match.outcome.resize(pixels);
  std::size_t at = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x, ++at) {
      const std::size_t to = places(x, y);
      match.outcome[to] = judge.judge(x, at);
      match.disparity[to] = refined_.disparity[at];
      match.correlation[to] = refined_.correlation[at];
      match.sigma[to] = refined_.sigma[at];
    }
}

} // namespace pcl::acmap
