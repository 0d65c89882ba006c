#include "best_scores.h"
#include "score_table.h"

#include <pcl/core/impl/parallel.h>

#include <oneapi/tbb/combinable.h>

#include <numeric>

namespace pcl::acmap {

namespace {

/** A source patch, its best target, and the best score of either at another position.
 */
struct BestMatch {
  std::int32_t source = 0;
  BestScore target;
  std::int32_t second = no_score;
};

/** Without this term of noise, two nearly identical patches could differ by any factor.
 */
constexpr float noise = 0.003F;

/** Ratio of the distances of the best and the second best score from 1. */
float
ambiguityOf(const BestMatch& candidate)
{
  return (1 - coefficientOf(candidate.target.score) + noise) /
         (1 - coefficientOf(candidate.second) + noise);
}

/** A score below which neither a best nor a second best one has an effect on matches:
 * even of the weakest best score it is distinct. */
std::int32_t
minimumOfInterest(const LogPolarSettings& settings)
{
  constexpr float rounding = 1e-3F, lowest = -1.01F;
  const float second =
      1 + noise - (1 + noise - settings.min_score) / settings.max_ambiguity;
  const float minimum = std::min(settings.min_score, second) - rounding;
  return static_cast<std::int32_t>(std::max(minimum, lowest) * score_length *
                                   score_length);
}

/** The steps of \ref matchPatches. */
class PatchMatching {
public:
  PatchMatching(const PlacedPatches& source,
                const PlacedPatches& target,
                const MatchGate& gate,
                const LogPolarSettings& settings,
                MatchCounts& counts)
  : source_(source)
  , target_(target)
  , gate_(gate)
  , settings_(settings)
  , minimum_(minimumOfInterest(settings))
  , counts_(counts)
  {}

  std::vector<BestMatch>
  run() const
  {
    std::vector<BestMatch> candidates = mutualMatches();
    keepDistinctTargets(candidates);
    return candidates;
  }

private:
  /** Finds strong and distinct targets that are mutually the best. */
  std::vector<BestMatch>
  mutualMatches() const
  {
    const std::size_t targets = target_.patches.pixels.size();
    std::vector<std::int32_t> rows(source_.patches.pixels.size());
    std::iota(rows.begin(), rows.end(), 0);
    std::vector<BestMatch> candidates(rows.size());
    oneapi::tbb::combinable<ColumnBests> parts([&] { return ColumnBests(targets); });
    const ScoreTable table(source_, target_, gate_, settings_, minimum_);
    table.forEachRow(rows, [&](std::size_t row, const std::int32_t* scores) {
      const auto source = static_cast<std::int32_t>(row);
      parts.local().add(source, scores);
      candidates[row] = {source, bestOf(scores, targets), minimum_};
      findSecond(scores, target_.places, candidates[row].target.index, candidates[row]);
    });
    ColumnBests bests(targets);
    parts.combine_each([&](const ColumnBests& part) { bests.add(part); });

    std::vector<BestMatch> kept;
    for (const BestMatch& candidate : candidates) {
      const auto target = static_cast<std::size_t>(candidate.target.index);
      if (!isStrong(candidate))
        ++counts_.weak;
      else if (!isDistinct(candidate))
        ++counts_.ambiguous;
      else if (bests.rowOf(target) != candidate.source)
        ++counts_.one_sided;
      else
        kept.push_back(candidate);
    }
    return kept;
  }

  /** Applies the test of distinctness from the other side, so that the result is
   * symmetric. */
  void
  keepDistinctTargets(std::vector<BestMatch>& candidates) const
  {
    std::vector<std::int32_t> rows;
    for (const BestMatch& candidate : candidates)
      rows.push_back(candidate.target.index);
    const ScoreTable table(target_, source_, gate_, settings_, minimum_);
    table.forEachRow(rows, [&](std::size_t k, const std::int32_t* scores) {
      findSecond(scores, source_.places, candidates[k].source, candidates[k]);
    });
    const auto is_ambiguous = [&](const BestMatch& candidate) {
      return !isDistinct(candidate);
    };
    const auto end = std::remove_if(candidates.begin(), candidates.end(), is_ambiguous);
    counts_.ambiguous += static_cast<std::size_t>(candidates.end() - end);
    candidates.erase(end, candidates.end());
  }

  void
  findSecond(const std::int32_t* scores,
             const PatchPlaces& places,
             std::int32_t best,
             BestMatch& candidate) const
  {
    if (isStrong(candidate))
      candidate.second = std::max(candidate.second,
                                  bestElsewhere(scores,
                                                places,
                                                static_cast<std::size_t>(best),
                                                settings_.second_distance));
  }

  bool
  isStrong(const BestMatch& candidate) const
  {
    return candidate.target.index >= 0 &&
           coefficientOf(candidate.target.score) >= settings_.min_score;
  }

  bool
  isDistinct(const BestMatch& candidate) const
  {
    return ambiguityOf(candidate) < settings_.max_ambiguity;
  }

  PlacedPatches source_, target_;
  const MatchGate& gate_;
  const LogPolarSettings& settings_;
  std::int32_t minimum_; ///< lower scores may be left out, and count as this one
  MatchCounts& counts_;
};

} // namespace

std::vector<PatchMatch>
matchPatches(const LogPolarPatches& source,
             const LogPolarPatches& target,
             const std::vector<Eigen::Vector3f>& source_points,
             const std::vector<Eigen::Vector3f>& target_points,
             const MatchGate& gate,
             const LogPolarSettings& settings,
             MatchCounts& counts)
{
  counts = {};
  if (source.pixels.empty() || target.pixels.empty()) {
    counts.weak = source.pixels.size();
    return {};
  }
  const PatchPlaces source_places = placesOf(source, source_points, gate, 0);
  const PatchPlaces target_places =
      placesOf(target, target_points, gate, gate.distance_per_metre);
  const PatchMatching matching(
      {source, source_places}, {target, target_places}, gate, settings, counts);
  const std::vector<BestMatch> candidates =
      withThreads(settings.threads, [&] { return matching.run(); });
  std::vector<PatchMatch> matches;
  for (const BestMatch& candidate : candidates)
    matches.push_back(
        {source.keypoint[static_cast<std::size_t>(candidate.source)],
         target.keypoint[static_cast<std::size_t>(candidate.target.index)],
         coefficientOf(candidate.target.score),
         ambiguityOf(candidate)});
  return matches;
}

} // namespace pcl::acmap
