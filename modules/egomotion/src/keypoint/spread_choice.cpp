#include "spread_choice.h"

#include <algorithm>
#include <functional>
#include <tuple>

namespace pcl::acmap {

namespace {

struct Candidate {
  std::int32_t turn = 0; ///< index of the cell, later the rank within the cell
  GradientMaximum maximum;

  bool
  operator<(const Candidate& other) const
  {
    return std::tuple(turn, -maximum.squared_gradient, maximum.pixel) <
           std::tuple(other.turn, -other.maximum.squared_gradient, other.maximum.pixel);
  }
};

std::vector<Candidate>
inTurns(const std::vector<GradientMaximum>& maxima,
        int width,
        const KeypointSettings& settings)
{
  const int cells = width / settings.cell_width + 1;
  std::vector<Candidate> candidates;
  for (const GradientMaximum& maximum : maxima) {
    const int column = maximum.pixel % width / settings.cell_width;
    const int row = maximum.pixel / width / settings.cell_height;
    candidates.push_back({row * cells + column, maximum});
  }
  std::sort(candidates.begin(), candidates.end());
  std::int32_t cell = -1, turn = 0;
  for (Candidate& candidate : candidates) {
    turn = candidate.turn == cell ? turn + 1 : 0;
    cell = candidate.turn;
    candidate.turn = turn;
  }
  return candidates;
}

/** Removes the maxima that are weak in comparison with the wanted number of strongest.
 */
void
dropWeak(std::vector<GradientMaximum>& maxima, std::size_t wanted)
{
  constexpr float min_share = 0.5F * 0.5F; // of the squared gradient
  std::vector<float> strengths;
  for (const GradientMaximum& maximum : maxima)
    strengths.push_back(maximum.squared_gradient);
  const auto last = strengths.begin() + static_cast<std::ptrdiff_t>(wanted - 1);
  std::nth_element(strengths.begin(), last, strengths.end(), std::greater<>());
  const float least = min_share * *last;
  const auto is_weak = [&](const GradientMaximum& maximum) {
    return maximum.squared_gradient < least;
  };
  maxima.erase(std::remove_if(maxima.begin(), maxima.end(), is_weak), maxima.end());
}

} // namespace

std::vector<std::int32_t>
spreadChoice(std::vector<GradientMaximum> maxima,
             int width,
             const KeypointSettings& settings)
{
  std::vector<std::int32_t> pixels;
  if (maxima.size() <= settings.most) {
    for (const GradientMaximum& maximum : maxima)
      pixels.push_back(maximum.pixel);
    return pixels;
  }
  dropWeak(maxima, settings.most);
  std::vector<Candidate> candidates = inTurns(maxima, width, settings);
  const auto end = candidates.begin() + static_cast<std::ptrdiff_t>(settings.most);
  std::nth_element(candidates.begin(), end, candidates.end());
  for (std::size_t k = 0; k < settings.most; ++k)
    pixels.push_back(candidates[k].maximum.pixel);
  std::sort(pixels.begin(), pixels.end());
  return pixels;
}

} // namespace pcl::acmap
