#include "confirmed_shots.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr int radius = 3;         // px, of the square around a pixel
constexpr float max_distance = 1; // px, between disparities of one surface
constexpr std::size_t around_each = 3;

// One shot alone is often that of a silhouette, which hides the pixel from a neighbour.
constexpr std::ptrdiff_t min_shots = 2;

bool
agree(float a, float b)
{
  return std::abs(a - b) <= max_distance;
}

} // namespace

ConfirmedShots::ConfirmedShots(const std::vector<MatchedDisparity>& shots,
                               std::size_t min_support)
: shots_(shots)
, min_around_(around_each * min_support)
{}

void
ConfirmedShots::collectOwn(std::size_t pixel)
{
  own_.clear();
  for (const MatchedDisparity& shot : shots_)
    if (shot.outcome[pixel] == DisparityOutcome::Matched)
      own_.push_back({shot.disparity.values[pixel], shot.sigma[pixel]});
}

void
ConfirmedShots::collectAround(std::size_t pixel)
{
  around_.clear();
  const auto width = static_cast<std::size_t>(shots_.front().disparity.width);
  const auto height = static_cast<std::size_t>(shots_.front().disparity.height);
  const std::size_t x = pixel % width, y = pixel / width;
  const auto first = [](std::size_t at) {
    return at - std::min<std::size_t>(at, radius);
  };
  for (const MatchedDisparity& shot : shots_)
    for (std::size_t v = first(y); v < std::min(y + radius + 1, height); ++v)
      for (std::size_t u = first(x); u < std::min(x + radius + 1, width); ++u)
        if (shot.outcome[v * width + u] == DisparityOutcome::Matched)
          around_.push_back(shot.disparity.values[v * width + u]);
}

std::size_t
ConfirmedShots::confirmationsOf(float disparity) const
{
  return static_cast<std::size_t>(
      std::count_if(around_.begin(), around_.end(), [=](float other) {
        return agree(disparity, other);
      }));
}

void
ConfirmedShots::fuse(std::size_t pixel, MatchedDisparity& fused)
{
  collectOwn(pixel);
  if (own_.empty())
    return;
  collectAround(pixel);
  sortShots(own_.data(), own_.data() + own_.size());
  float best = 0;
  std::size_t confirmations = 0;
  for (const ShotDisparity& shot : own_)
    if (const std::size_t number = confirmationsOf(shot.disparity);
        number > confirmations) {
      confirmations = number;
      best = shot.disparity;
    }
  if (confirmations < min_around_ || !isMajority(confirmations, around_.size()))
    return;
  const auto [begin, end] = std::equal_range(
      own_.data(),
      own_.data() + own_.size(),
      ShotDisparity{best, 0},
      [](const ShotDisparity& a, const ShotDisparity& b) {
        return a.disparity < b.disparity && !agree(a.disparity, b.disparity);
      });
  if (end - begin < std::min(min_shots, static_cast<std::ptrdiff_t>(shots_.size())))
    return;
  const FusedDisparity result = consistentMeanOfShots(begin, end);
  if (!result.is_consistent)
    return;
  fused.disparity.values[pixel] = result.disparity;
  fused.sigma[pixel] = result.sigma;
  fused.support[pixel] = result.support;
  fused.outcome[pixel] = DisparityOutcome::Matched;
}

} // namespace pcl::acmap
