#include "pair_refinement.h"

#include "pair_costs.h"
#include "quarter_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::acmap {

namespace {

constexpr int reach = 2;                                 ///< radius of the window, px
constexpr std::size_t places = WindowAtQuarters::places; ///< from -1 px on
constexpr float unit = ShotStack::unit;                  ///< per grey level
constexpr float noise_floor = 0.25F * unit * unit;
constexpr float quarter = 0.25F; ///< px

/** Share of the values of a window that are independent: blur and interpolation
 * correlate adjacent values. Measured in simulation, see
 * doc/stereo/trinocular_matching.md. */
constexpr float independent_share = 0.34F;

/** Sums over a window. */
class RefinementWindow {
public:
  explicit RefinementWindow(bool centred)
  : centred_(centred)
  {}

  /** Adds the pixels of a row whose winners differ by at most 1 from that of the
   * middle.
   * \param[in] begin, end columns */
  void
  add(const QuarterSums& row, int begin, int end, int winner)
  {
    const int* const winners = row.winners();
    const SubPixelSums* const sums = row.sums();
    const float *const squares = row.squares(), *const values = row.values();
    int count = count_;
    float square = squares_, value = values_;
    for (int x = begin; x < end; ++x) {
      const int difference = winner - winners[x];
      if (difference < -1 || difference > 1)
        continue;
      pixels_[static_cast<std::size_t>(count++)] =
          sums[x].products + 4 + 4 * difference;
      square += squares[x];
      value += values[x];
    }
    count_ = count;
    squares_ = square;
    values_ = value;
  }

  /** Must be called after the last pixel was added. \param[in] shots values per pixel
   */
  void
  finish(int shots)
  {
    pairKernels().sumWindow(pixels_.data(), count_, !centred_, sums_);
    size_ = static_cast<float>(count_ * shots);
    floor_ = size_ * noise_floor;
    mean_ = centred_ ? 0.0F : values_ / size_;
    square_ = std::max(squares_ - size_ * mean_ * mean_, 0.0F);
  }

  /** ZNCC at a quarter pixel. */
  float
  correlate(std::size_t place) const
  {
    const float mean = centred_ ? 0.0F : sums_.values[place] / size_;
    const float square = std::max(sums_.squares[place] - size_ * mean * mean, 0.0F);
    return (sums_.products[place] - size_ * mean_ * mean) /
           std::sqrt((square_ + floor_) * (square + floor_));
  }

  float
  variance() const
  {
    return square_ / size_;
  }

  /** Number of values that are compared. */
  float
  size() const
  {
    return size_;
  }

private:
  static constexpr std::size_t pixels = (2 * reach + 1) * (2 * reach + 1);

  bool centred_;
  std::array<const float*, pixels> pixels_;
  int count_ = 0;
  float squares_ = 0, values_ = 0; ///< sums over the reference
  WindowAtQuarters sums_;
  float size_ = 0, floor_ = 0, mean_ = 0, square_ = 0;
};

/** Rows of sums, as many as the height of a window. */
class SumRows {
public:
  SumRows(const ShotStack& reference,
          const ShotStack& target,
          const PairWinners& winners,
          const DisparityRange& range)
  : reference_(reference)
  , target_(target)
  , winners_(winners)
  , range_(range)
  {}

  void
  fill(int y)
  {
    if (y >= 0 && y < reference_.height())
      row(y).fill(reference_, target_, winners_, range_, y);
  }

  RefinementWindow
  windowAt(int x, int y, bool centred)
  {
    RefinementWindow window(centred);
    const int begin = std::max(x - reach, 0), end = std::min(x + reach + 1, width());
    const int winner = row(y).winners()[x];
    for (int j = std::max(y - reach, 0); j <= std::min(y + reach, height() - 1); ++j)
      window.add(row(j), begin, end, winner);
    window.finish(reference_.shots());
    return window;
  }

  /** ZNCC of the pixel's own levels over time. An occluded pixel takes the disparity of
   * adjacent pixels, and its window fits as well as theirs; only its own levels differ.
   */
  float
  ownCorrelation(int x, int y, float offset)
  {
    const auto at = static_cast<std::size_t>(std::lround(offset / quarter) +
                                             SubPixelSums::quarters / 2);
    const SubPixelSums& sums = row(y).sums()[x];
    const float floor = static_cast<float>(reference_.shots()) * noise_floor;
    return sums.products[at] /
           std::sqrt((row(y).squares()[x] + floor) * (sums.squares[at] + floor));
  }

  bool
  isInside(int x, int y)
  {
    return row(y).winners()[x] != QuarterSums::outside;
  }

  int
  width() const
  {
    return reference_.width();
  }

private:
  int
  height() const
  {
    return reference_.height();
  }

  QuarterSums&
  row(int y)
  {
    return rows_[static_cast<std::size_t>(y) % rows_.size()];
  }

  const ShotStack& reference_;
  const ShotStack& target_;
  const PairWinners& winners_;
  const DisparityRange& range_;
  std::array<QuarterSums, 2 * reach + 1> rows_;
};

struct Peak {
  float offset = 0;      ///< px
  float correlation = 0; ///< ZNCC
  float curvature = 0;   ///< negative second derivative of it, 1 / px^2, at least 0
};

Peak
peakOf(const RefinementWindow& window)
{
  std::array<float, places> correlations{};
  correlations.fill(std::numeric_limits<float>::quiet_NaN());
  const auto at = [&](std::size_t place) {
    if (std::isnan(correlations[place]))
      correlations[place] = window.correlate(place);
    return correlations[place];
  };
  std::size_t best = places / 2;
  // Climbs from the winner by at most half a pixel: a higher peak beyond a valley is
  // another match, and a peak farther away belongs to a surface next to an edge.
  while (best < 3 * places / 4 && at(best + 1) > at(best))
    ++best;
  while (best > places / 4 && at(best - 1) > at(best))
    --best;
  const float left = at(best - 1), right = at(best + 1);
  const float bend = 2.0F * at(best) - left - right;
  Peak peak;
  float shift = 0.0F;
  if (bend > 0.0F)
    shift = std::clamp(0.5F * (right - left) / bend, -0.5F, 0.5F);
  peak.offset =
      quarter * (static_cast<float>(best) - static_cast<float>(places / 2) + shift);
  peak.correlation = std::min(at(best) + 0.25F * (right - left) * shift, 1.0F);
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
  const auto refine = [&](SumRows& sums, int x, int y) {
    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x);
    if (!sums.isInside(x, y)) {
      refined.disparity[at] = std::numeric_limits<float>::quiet_NaN();
      refined.correlation[at] = refined.deviation[at] = 0.0F;
      refined.sigma[at] = 1.0F;
      return;
    }
    const RefinementWindow window = sums.windowAt(x, y, centred);
    const Peak peak = peakOf(window);
    refined.disparity[at] =
        static_cast<float>(range.first + winners.index[at]) + peak.offset;
    refined.correlation[at] =
        centred ? std::min(peak.correlation, sums.ownCorrelation(x, y, peak.offset))
                : peak.correlation;
    refined.sigma[at] = sigmaOf(peak, window.size());
    refined.deviation[at] = std::sqrt(window.variance()) / unit;
  };
  forRowBlocks(height, [&](int begin, int end) {
    SumRows sums(reference, target, winners, range);
    for (int y = begin - reach; y < begin + reach; ++y)
      sums.fill(y);
    for (int y = begin; y < end; ++y) {
      sums.fill(y + reach);
      for (int x = 0; x < width; ++x)
        refine(sums, x, y);
    }
  });
}

} // namespace pcl::acmap
