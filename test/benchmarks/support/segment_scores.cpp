#include "segment_scores.h"

#include "statistics.h"

#include <algorithm>

namespace pcl::acmap::bench {
namespace {

constexpr double overlap = 0.8;

bool
isMost(std::size_t part, std::size_t whole)
{
  return part > 0 && static_cast<double>(part) >= overlap * static_cast<double>(whole);
}

/** Classifies each plane once, in the order of the passes. */
class Comparison {
public:
  explicit Comparison(const PlaneOverlaps& overlaps)
  : overlaps_(overlaps)
  , truth_told_(overlaps.truths())
  , found_told_(overlaps.founds())
  {}

  void
  findCorrect(std::size_t large_count, SegmentScores& scores)
  {
    for (std::size_t f = 0; f < overlaps_.founds(); ++f)
      for (std::size_t t = 0; t < overlaps_.truths(); ++t)
        if (isMost(overlaps_.common(f, t), overlaps_.truthSize(t)) &&
            isMost(overlaps_.common(f, t), overlaps_.labelledSize(f))) {
          truth_told_[t] = found_told_[f] = true;
          ++scores.correct;
          scores.correct_large += overlaps_.truthSize(t) >= large_count;
        }
  }

  void
  findOver(SegmentScores& scores)
  {
    for (std::size_t t = 0; t < overlaps_.truths(); ++t) {
      std::vector<std::size_t> parts;
      std::size_t sum = 0;
      for (std::size_t f = 0; f < overlaps_.founds(); ++f)
        if (!found_told_[f] &&
            isMost(overlaps_.common(f, t), overlaps_.labelledSize(f))) {
          parts.push_back(f);
          sum += overlaps_.common(f, t);
        }
      if (truth_told_[t] || parts.size() < 2 || !isMost(sum, overlaps_.truthSize(t)))
        continue;
      ++scores.over;
      truth_told_[t] = true;
      for (const std::size_t f : parts)
        found_told_[f] = true;
    }
  }

  void
  findUnder(SegmentScores& scores)
  {
    for (std::size_t f = 0; f < overlaps_.founds(); ++f) {
      std::vector<std::size_t> parts;
      std::size_t sum = 0;
      for (std::size_t t = 0; t < overlaps_.truths(); ++t)
        if (!truth_told_[t] && isMost(overlaps_.common(f, t), overlaps_.truthSize(t))) {
          parts.push_back(t);
          sum += overlaps_.common(f, t);
        }
      if (found_told_[f] || parts.size() < 2 || !isMost(sum, overlaps_.labelledSize(f)))
        continue;
      ++scores.under;
      found_told_[f] = true;
      for (const std::size_t t : parts)
        truth_told_[t] = true;
    }
  }

  void
  countRest(SegmentScores& scores) const
  {
    for (const bool told : truth_told_)
      scores.missed += !told;
    for (std::size_t f = 0; f < overlaps_.founds(); ++f)
      scores.noise +=
          !found_told_[f] && 2 * overlaps_.labelledSize(f) >= overlaps_.foundSize(f);
  }

private:
  const PlaneOverlaps& overlaps_;
  std::vector<bool> truth_told_;
  std::vector<bool> found_told_;
};

double
labelsRight(const PlaneOverlaps& overlaps)
{
  std::size_t points = 0, right = 0;
  for (std::size_t t = 0; t < overlaps.truths(); ++t) {
    std::size_t maximum = 0;
    for (std::size_t f = 0; f < overlaps.founds(); ++f)
      if (overlaps.majority(f) == static_cast<std::int32_t>(t))
        maximum = std::max(maximum, overlaps.common(f, t));
    points += overlaps.truthSize(t);
    right += maximum;
  }
  return percent(right, points);
}

} // namespace

SegmentScores
scoreSegments(const PlaneOverlaps& overlaps, std::size_t large_count)
{
  SegmentScores scores;
  scores.truths = overlaps.truths();
  scores.given = overlaps.founds();
  for (std::size_t t = 0; t < overlaps.truths(); ++t)
    scores.large += overlaps.truthSize(t) >= large_count;
  Comparison comparison(overlaps);
  comparison.findCorrect(large_count, scores);
  comparison.findOver(scores);
  comparison.findUnder(scores);
  comparison.countRest(scores);
  scores.labels = labelsRight(overlaps);
  return scores;
}

} // namespace pcl::acmap::bench
