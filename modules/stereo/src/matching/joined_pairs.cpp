#include "joined_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap {

namespace {

struct PixelMatch {
  float disparity;
  float sigma;
  float correlation;
  DisparityOutcome outcome;
};

PixelMatch
pixelOf(const PairMatch& pair, std::size_t at, double scale)
{
  return {static_cast<float>(scale * pair.disparity[at]),
          static_cast<float>(scale * pair.sigma[at]),
          pair.correlation[at],
          pair.outcome[at]};
}

/** The mean weighted by inverse variances. */
PixelMatch
meanOf(const PixelMatch& a, const PixelMatch& b)
{
  const double weight_a = 1.0 / (static_cast<double>(a.sigma) * a.sigma);
  const double weight_b = 1.0 / (static_cast<double>(b.sigma) * b.sigma);
  const double sum = weight_a + weight_b;
  return {static_cast<float>((weight_a * a.disparity + weight_b * b.disparity) / sum),
          static_cast<float>(1.0 / std::sqrt(sum)),
          std::max(a.correlation, b.correlation),
          DisparityOutcome::Matched};
}

/** Returns the pair that passed more of the tests; its reason is kept. */
PixelMatch
rejectedOf(const PixelMatch& a, const PixelMatch& b)
{
  return a.outcome < b.outcome ? b : a;
}

bool
isMatched(const PixelMatch& pixel)
{
  return pixel.outcome == DisparityOutcome::Matched;
}

/** Of two matches that contradict each other, returns the one with a much smaller
 * standard deviation, since along a line all positions fit; otherwise the one with the
 * higher correlation. */
PixelMatch
betterOf(const PixelMatch& a, const PixelMatch& b)
{
  constexpr float much = 3.0F;
  if (a.sigma > much * b.sigma || b.sigma > much * a.sigma)
    return a.sigma < b.sigma ? a : b;
  return b.correlation > a.correlation ? b : a;
}

bool
agree(const PixelMatch& a, const PixelMatch& b, const JoinSettings& settings)
{
  return isMatched(a) && isMatched(b) &&
         std::abs(a.disparity - b.disparity) <= settings.agreement;
}

PixelMatch
joined(const PixelMatch& a, const PixelMatch& b, const JoinSettings& settings)
{
  if (agree(a, b, settings))
    return meanOf(a, b);
  if (isMatched(a) && isMatched(b)) {
    PixelMatch better = betterOf(a, b);
    if (settings.require_agreement)
      better.outcome = DisparityOutcome::PairsDisagree;
    return better;
  }
  if (isMatched(a) || isMatched(b))
    return isMatched(a) ? a : b;
  return rejectedOf(a, b);
}

void
prepare(std::size_t pixels, MatchedDisparity& matched)
{
  matched.disparity.values.resize(pixels);
  matched.sigma.resize(pixels);
  matched.support.resize(pixels);
  matched.outcome.resize(pixels);
}

void
put(const PixelMatch& pixel,
    std::uint16_t support,
    std::size_t at,
    MatchedDisparity& matched)
{
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  matched.outcome[at] = pixel.outcome;
  matched.disparity.values[at] = isMatched(pixel) ? pixel.disparity : none;
  matched.sigma[at] = isMatched(pixel) ? pixel.sigma : none;
  matched.support[at] = isMatched(pixel) ? support : 0;
}

} // namespace

void
takePair(const PairMatch& pair, std::uint16_t support, MatchedDisparity& matched)
{
  prepare(pair.outcome.size(), matched);
  for (std::size_t at = 0; at < pair.outcome.size(); ++at)
    put(pixelOf(pair, at, 1.0), support, at, matched);
}

std::size_t
joinPairs(const PairMatch& first,
          const PairMatch& second,
          const JoinSettings& settings,
          std::uint16_t support,
          MatchedDisparity& matched)
{
  prepare(first.outcome.size(), matched);
  std::size_t agreed = 0;
  for (std::size_t at = 0; at < first.outcome.size(); ++at) {
    const PixelMatch a = pixelOf(first, at, 1.0);
    const PixelMatch b = pixelOf(second, at, settings.ratio);
    put(joined(a, b, settings), support, at, matched);
    agreed += agree(a, b, settings);
  }
  return agreed;
}

} // namespace pcl::acmap
