#include "pair_refinement.h"

#include "pair_costs.h"
#include "quarter_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::acmap {

namespace {

constexpr int reach = 2; ///< radius of the window, px
constexpr int places = WindowMatch::places;
constexpr float unit = ShotStack::unit; ///< per grey level
constexpr float noise_floor = 0.25F * unit * unit;
constexpr float quarter = 0.25F; ///< px

/** Share of the values of a window that are independent: blur and interpolation
 * correlate adjacent values. Measured in simulation, see
 * doc/stereo/trinocular_matching.md. */
constexpr float independent_share = 0.34F;

/** Rows of sums, as many as the height of a window. */
class SumRows {
public:
  SumRows(const ShotStack& reference,
          const ShotStack& target,
          const PairWinners& winners,
          const DisparityRange& range,
          bool centred)
  : reference_(reference)
  , target_(target)
  , winners_(winners)
  , range_(range)
  , terms_{reference.width(), reference.shots(), noise_floor, centred}
  , matches_(static_cast<std::size_t>(reference.width()))
  {}

  void
  fill(int y)
  {
    if (y >= 0 && y < reference_.height())
      row(y).fill(reference_, target_, winners_, range_, terms_.centred, y);
  }

  /** Correlates the windows around the pixels of a row. */
  const std::vector<WindowMatch>&
  correlate(int y)
  {
    std::array<const MatchedRow*, 2 * reach + 1> rows{};
    int count = 0;
    const int last = std::min(y + reach, reference_.height() - 1);
    for (int j = std::max(y - reach, 0); j <= last; ++j)
      rows[static_cast<std::size_t>(count++)] = &row(j).row();
    pairKernels().correlateAround(
        rows.data(), count, row(y).row(), terms_, matches_.data());
    return matches_;
  }

  /** ZNCC of the pixel's own levels over time. An occluded pixel takes the disparity of
   * adjacent pixels, and its window fits as well as theirs; only its own levels differ.
   */
  float
  ownCorrelation(int x, int y, float offset)
  {
    constexpr int far = 8; // makes the number positive, so that its part is cut off
    const int place = static_cast<int>(offset / quarter + (far + 0.5F)) - far;
    const float floor = static_cast<float>(reference_.shots()) * noise_floor;
    return row(y).ownCorrelation(x, place, floor);
  }

  bool
  isInside(int x, int y)
  {
    return row(y).isInside(x);
  }

private:
  QuarterSums&
  row(int y)
  {
    return rows_[static_cast<std::size_t>(y) % rows_.size()];
  }

  const ShotStack& reference_;
  const ShotStack& target_;
  const PairWinners& winners_;
  const DisparityRange& range_;
  WindowTerms terms_;
  std::array<QuarterSums, 2 * reach + 1> rows_;
  std::vector<WindowMatch> matches_;
};

struct Peak {
  float offset = 0;      ///< px
  float correlation = 0; ///< ZNCC
  float curvature = 0;   ///< negative second derivative of it, 1 / px^2, at least 0
};

Peak
peakOf(const float (&correlations)[places])
{
  int best = places / 2;
  // Climbs from the winner by at most half a pixel: a higher peak beyond a valley is
  // another match, and a peak farther away belongs to a surface next to an edge.
  while (best < 3 * places / 4 && correlations[best + 1] > correlations[best])
    ++best;
  while (best > places / 4 && correlations[best - 1] > correlations[best])
    --best;
  const float left = correlations[best - 1], right = correlations[best + 1];
  const float bend = 2.0F * correlations[best] - left - right;
  Peak peak;
  float shift = 0.0F;
  if (bend > 0.0F)
    shift = std::clamp(0.5F * (right - left) / bend, -0.5F, 0.5F);
  peak.offset = quarter * (static_cast<float>(best - places / 2) + shift);
  peak.correlation =
      std::min(correlations[best] + 0.25F * (right - left) * shift, 1.0F);
  peak.curvature = std::max(bend, 0.0F) / (quarter * quarter);
  return peak;
}

/** Standard deviation of a least-squares shift: 1 minus the correlation is the noise of
 * both views, its curvature depends on the gradient of the levels. */
float
sigmaOf(const Peak& peak, float values)
{
  constexpr float maximum = 1.0F;
  const float noise = 2.0F * std::max(1.0F - peak.correlation, 1e-6F);
  const float information =
      independent_share * values * std::max(peak.curvature, 1e-6F);
  return std::min(std::sqrt(noise / information), maximum);
}

} // namespace

void
RefinedPair::resize(std::size_t pixels)
{
  disparity.resize(pixels);
  correlation.resize(pixels);
  sigma.resize(pixels);
  deviation.resize(pixels);
}

void
refineWinners(const ShotStack& reference,
              const ShotStack& target,
              const PairWinners& winners,
              const DisparityRange& range,
              bool centred,
              RefinedPair& refined)
{
  refined.resize(winners.index.size());
  const int height = reference.height(), width = reference.width();
  const auto refine = [&](SumRows& sums, const WindowMatch& window, int x, int y) {
    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x);
    if (!sums.isInside(x, y)) {
      refined.disparity[at] = std::numeric_limits<float>::quiet_NaN();
      refined.correlation[at] = refined.deviation[at] = 0.0F;
      refined.sigma[at] = 1.0F;
      return;
    }
    const Peak peak = peakOf(window.correlation);
    refined.disparity[at] =
        static_cast<float>(range.first + winners.index[at]) + peak.offset;
    refined.correlation[at] =
        centred ? std::min(peak.correlation, sums.ownCorrelation(x, y, peak.offset))
                : peak.correlation;
    refined.sigma[at] = sigmaOf(peak, window.size);
    refined.deviation[at] = std::sqrt(window.variance) / unit;
  };
  forRowBlocks(height, [&](int begin, int end) {
    SumRows sums(reference, target, winners, range, centred);
    for (int y = begin - reach; y < begin + reach; ++y)
      sums.fill(y);
    for (int y = begin; y < end; ++y) {
      sums.fill(y + reach);
      const std::vector<WindowMatch>& windows = sums.correlate(y);
      for (int x = 0; x < width; ++x)
        refine(sums, windows[static_cast<std::size_t>(x)], x, y);
    }
  });
}

} // namespace pcl::acmap
