#include "fused_shots.h"

#include "confirmed_shots.h"
#include "shot_statistics.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <limits>

namespace pcl::acmap {

namespace {

DisparityOutcome
commonestOutcome(const std::vector<MatchedDisparity>& shots, std::size_t pixel)
{
  std::array<std::size_t, disparity_outcomes> counts{};
  for (const MatchedDisparity& shot : shots)
    ++counts[static_cast<std::size_t>(shot.outcome[pixel])];
  return static_cast<DisparityOutcome>(std::max_element(counts.begin(), counts.end()) -
                                       counts.begin());
}

/** \brief Fuses one pixel after another; one object per thread, because it has a
 * buffer. */
class PixelFusion {
public:
  PixelFusion(const std::vector<MatchedDisparity>& shots,
              ShotStatistic statistic,
              std::size_t min_support)
  : shots_(shots)
  , statistic_(statistic)
  , min_support_(min_support)
  , samples_(shots.size())
  , confirmed_(shots, min_support)
  {}

  void
  fuse(std::size_t pixel, MatchedDisparity& fused)
  {
    std::size_t found = 0;
    for (const MatchedDisparity& shot : shots_)
      if (shot.outcome[pixel] == DisparityOutcome::Matched)
        samples_[found++] = {shot.disparity.values[pixel], shot.sigma[pixel]};
    if (found == 0)
      fused.outcome[pixel] = commonestOutcome(shots_, pixel);
    else
      fuseFound(found, pixel, fused);
  }

private:
  void
  fuseFound(std::size_t found, std::size_t pixel, MatchedDisparity& fused)
  {
    ShotDisparity* const begin = samples_.data();
    sortShots(begin, begin + found);
    const bool is_median = statistic_ == ShotStatistic::Median;
    if (found >= min_support_) {
      const FusedDisparity result = is_median
                                        ? medianOfShots(begin, begin + found)
                                        : consistentMeanOfShots(begin, begin + found);
      if (result.is_consistent && result.support >= min_support_)
        return set(result, pixel, fused);
      if (!result.is_consistent)
        fused.outcome[pixel] = DisparityOutcome::Inconsistent;
    }
    if (is_median)
      return;
    if (const auto result = confirmed_.fuse(begin, begin + found, pixel))
      set(*result, pixel, fused);
  }

  static void
  set(const FusedDisparity& result, std::size_t pixel, MatchedDisparity& fused)
  {
    fused.disparity.values[pixel] = result.disparity;
    fused.sigma[pixel] = result.sigma;
    fused.support[pixel] = result.support;
    fused.outcome[pixel] = DisparityOutcome::Matched;
  }

  const std::vector<MatchedDisparity>& shots_;
  ShotStatistic statistic_;
  std::size_t min_support_;
  std::vector<ShotDisparity> samples_;
  ConfirmedShots confirmed_;
};

} // namespace

MatchedDisparity
noDisparity(int width, int height, DisparityOutcome why)
{
  const std::size_t pixels =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::vector<float> none(pixels, std::numeric_limits<float>::quiet_NaN());
  return {{width, height, none},
          none,
          std::vector<std::uint16_t>(pixels),
          std::vector<DisparityOutcome>(pixels, why)};
}

MatchedDisparity
fuseShots(const std::vector<MatchedDisparity>& shots,
          ShotStatistic statistic,
          std::size_t min_support)
{
  const DisparityImage& size = shots.front().disparity;
  MatchedDisparity fused =
      noDisparity(size.width, size.height, DisparityOutcome::TooFewShots);
  parallelForChunks(fused.outcome.size(), [&](std::size_t begin, std::size_t end) {
    PixelFusion pixels(shots, statistic, min_support);
    for (std::size_t i = begin; i < end; ++i)
      pixels.fuse(i, fused);
  });
  return fused;
}

} // namespace pcl::acmap
