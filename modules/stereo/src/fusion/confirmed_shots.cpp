#include "confirmed_shots.h"

#include <algorithm>

namespace pcl::acmap {

namespace {

constexpr int radius = 3; // px, of the square around a pixel
constexpr std::size_t around_each = 3;

// One shot alone is often that of a silhouette, which hides the pixel from a neighbour.
constexpr std::ptrdiff_t min_shots = 2;

} // namespace

ConfirmedShots::ConfirmedShots(const std::vector<MatchedDisparity>& shots,
                               std::size_t min_support)
: shots_(shots)
, min_around_(around_each * min_support)
{}

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

std::optional<FusedDisparity>
ConfirmedShots::fuse(const ShotDisparity* begin,
                     const ShotDisparity* end,
                     std::size_t pixel)
{
  collectAround(pixel);
  float best = 0;
  std::size_t confirmations = 0;
  for (const ShotDisparity* shot = begin; shot != end; ++shot)
    if (const std::size_t number = confirmationsOf(shot->disparity);
        number > confirmations) {
      confirmations = number;
      best = shot->disparity;
    }
  if (confirmations < min_around_ || !isMajority(confirmations, around_.size()))
    return std::nullopt;
  const auto [first, last] = std::equal_range(
      begin, end, ShotDisparity{best, 0}, [](const auto& a, const auto& b) {
        return a.disparity < b.disparity && !agree(a.disparity, b.disparity);
      });
  if (last - first < std::min(min_shots, static_cast<std::ptrdiff_t>(shots_.size())))
    return std::nullopt;
  const FusedDisparity result = consistentMeanOfShots(first, last);
  return result.is_consistent ? std::optional(result) : std::nullopt;
}

} // namespace pcl::acmap
