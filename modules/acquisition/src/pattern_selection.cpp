#include <pcl/acquisition/pattern_selection.h>
#include <pcl/core/exceptions.h>

#include "pattern/pattern_contrast.h"

#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/core/impl/arguments.h>

#include <algorithm>
#include <limits>

namespace pcl {

namespace {

std::uint32_t
squareOf(int difference)
{
  return static_cast<std::uint32_t>(difference * difference);
}

} // namespace

/** A pattern that may be selected; only its samples are kept. */
struct PatternSelection::Candidate {
  std::uint32_t number;
  acmap::PatternSamples samples;
  std::uint64_t gain = std::numeric_limits<std::uint64_t>::max();
  std::size_t patterns = std::numeric_limits<std::size_t>::max(); ///< its gain is after
};

/** Gains fall with each pattern, so that an old one is an upper bound: only candidates
 * whose old gain is the highest are computed again. */
std::vector<PatternSelection::Candidate>::iterator
PatternSelection::bestOf(std::vector<Candidate>& candidates, std::size_t patterns) const
{
  while (true) {
    const auto best =
        std::max_element(candidates.begin(),
                         candidates.end(),
                         [](const auto& a, const auto& b) { return a.gain < b.gain; });
    if (best->patterns == patterns)
      return best;
    best->gain = gainOf(best->samples);
    best->patterns = patterns;
  }
}

void
PatternSelection::setDisparityRange(int pixels)
{
  acmap::requireInRange("disparity range", pixels, 4, 1024, "px");
  disparity_range_ = pixels;
}

void
PatternSelection::setSufficientContrast(double levels)
{
  acmap::requireInRange("sufficient contrast", levels, 1, 4000, "grey levels");
  contrast_ = levels;
}

void
PatternSelection::setNumberOfCandidates(int candidates)
{
  acmap::requireInRange("number of candidates", candidates, 1, 1000, "patterns");
  candidates_ = candidates;
}

void
PatternSelection::requireFitting(const RgbImage& pattern) const
{
  const auto pixels = [](std::int32_t side) { return static_cast<std::size_t>(side); };
  if (pattern.width < 1 || pattern.height < 1 ||
      pattern.values.size() != 3 * pixels(pattern.width) * pixels(pattern.height))
    throw acmap::BadArgument("the pattern is incomplete");
  if (width_ > 0 && (pattern.width != width_ || pattern.height != height_))
    throw acmap::BadArgument("the pattern is of another size than those before");
}

void
PatternSelection::add(const RgbImage& pattern)
{
  requireFitting(pattern);
  const auto most = static_cast<std::uint32_t>(contrast_ * contrast_);
  acmap::PatternSamples(pattern).forPairs(
      disparity_range_ / acmap::PatternSamples::step,
      [&](std::size_t pair, int difference) {
        if (pair == sums_.size())
          sums_.push_back(0);
        sums_[pair] = std::min(sums_[pair] + squareOf(difference), most);
      });
  width_ = pattern.width;
  height_ = pattern.height;
}

std::uint64_t
PatternSelection::gainOf(const RgbImage& pattern) const
{
  requireFitting(pattern);
  return gainOf(acmap::PatternSamples(pattern));
}

std::uint64_t
PatternSelection::gainOf(const acmap::PatternSamples& samples) const
{
  const auto most = static_cast<std::uint32_t>(contrast_ * contrast_);
  std::uint64_t gain = 0;
  samples.forPairs(disparity_range_ / acmap::PatternSamples::step,
                   [&](std::size_t pair, int difference) {
                     const std::uint32_t before = pair < sums_.size() ? sums_[pair] : 0;
                     gain += std::min(squareOf(difference), most - before);
                   });
  return gain;
}

void
PatternSelection::clear()
{
  width_ = height_ = 0;
  sums_.clear();
}

std::vector<RgbImage>
PatternSelection::selectFrom(RandomLinePattern& generator, std::size_t count)
{
  std::vector<Candidate> candidates;
  std::vector<RgbImage> selected;
  std::uint32_t next = 0;
  while (selected.size() < count) {
    while (candidates.size() < static_cast<std::size_t>(candidates_)) {
      const RgbImage pattern = generator.generate(next);
      requireFitting(pattern);
      candidates.push_back({next++, acmap::PatternSamples(pattern)});
    }
    const auto best = bestOf(candidates, selected.size());
    selected.push_back(generator.generate(best->number));
    add(selected.back());
    candidates.erase(best);
  }
  return selected;
}

} // namespace pcl
