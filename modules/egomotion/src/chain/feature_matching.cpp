#include "chain/feature_matching.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

/** \brief Gate for all motions within the bounds: no point can move farther. */
MatchGate
gateOf(const EgomotionSettings& settings)
{
  MatchGate gate;
  gate.distance = static_cast<float>(settings.max_translation);
  gate.distance_per_metre = static_cast<float>(2 * std::sin(settings.max_rotation / 2));
  return gate;
}

} // namespace

std::vector<FeaturePair>
alikePairs(const EgomotionView& source,
           const EgomotionView& target,
           const EgomotionSettings& settings)
{
  std::vector<FeaturePair> pairs;
  MatchCounts counts;
  LogPolarSettings patch_settings = settings.patches;
  patch_settings.threads = settings.threads;
  const std::size_t levels = std::min(source.features.size(), target.features.size());
  for (std::size_t level = 0; level < levels; ++level) {
    const FeatureLevel& now = source.features[level];
    const FeatureLevel& before = target.features[level];
    for (const PatchMatch& match : matchPatches(now.patches,
                                                before.patches,
                                                now.places,
                                                before.places,
                                                gateOf(settings),
                                                patch_settings,
                                                counts))
      pairs.push_back(featurePair(source, target, level, match));
  }
  return pairs;
}

std::vector<FeaturePair>
consistentPairs(const std::vector<FeaturePair>& pairs, const WorstOutSettings& settings)
{
  std::vector<Eigen::Vector3f> source, target;
  for (const FeaturePair& pair : pairs) {
    source.push_back(pair.source.cast<float>());
    target.push_back(pair.target.cast<float>());
  }
  std::vector<FeaturePair> kept;
  for (const std::int32_t position : leaveWorstOut(source, target, settings).kept)
    kept.push_back(pairs[static_cast<std::size_t>(position)]);
  return kept;
}

} // namespace pcl::acmap
