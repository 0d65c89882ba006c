#include "chain/feature_pairs.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

/** \brief Covariance of a keypoint of a level. */
Eigen::Matrix3d
keypointCovariance(const EgomotionView& view, std::size_t level, std::int32_t keypoint)
{
  const FeatureLevel& features = view.features[level];
  const auto place = static_cast<std::size_t>(keypoint);
  return placeCovariance(features.places[place].cast<double>(),
                         features.sigmas[place],
                         features.scale,
                         view.pinhole);
}

Eigen::Matrix3d
differenceCovariance(const FeaturePair& pair, const Eigen::Isometry3d& T_target_source)
{
  return pair.target_covariance + T_target_source.linear() * pair.source_covariance *
                                      T_target_source.linear().transpose();
}

/** \brief Gate for all motions within the bounds: no point can move farther. The paper
 * has no bounds. */
MatchGate
gateOf(const EgomotionSettings& settings)
{
  MatchGate gate;
  if (settings.paper)
    return gate;
  gate.distance = static_cast<float>(settings.max_translation);
  gate.distance_per_metre = static_cast<float>(2 * std::sin(settings.max_rotation / 2));
  return gate;
}

} // namespace

Eigen::Matrix3d
placeCovariance(const Eigen::Vector3d& place,
                double sigma,
                double scale,
                const std::optional<Pinhole>& pinhole)
{
  constexpr double across_pixels = 0.5; // error of a maximum located on whole pixels
  constexpr double usual_focal_length = 500;
  const double focal_length =
      pinhole ? (pinhole->fx + pinhole->fy) / 2 : usual_focal_length;
  const double across = across_pixels * scale * place.norm() / focal_length;
  const Eigen::Vector3d ray = place.normalized();
  return across * across * Eigen::Matrix3d::Identity() +
         std::max(sigma * sigma - across * across, 0.0) * ray * ray.transpose();
}

FeaturePair
featurePair(const EgomotionView& source,
            const EgomotionView& target,
            std::size_t level,
            const PatchMatch& match)
{
  const FeatureLevel& now = source.features[level];
  const FeatureLevel& before = target.features[level];
  const auto from = static_cast<std::size_t>(match.source);
  const auto to = static_cast<std::size_t>(match.target);
  return {now.pixels[from],
          before.pixels[to],
          now.places[from].cast<double>(),
          before.places[to].cast<double>(),
          keypointCovariance(source, level, match.source),
          keypointCovariance(target, level, match.target)};
}

double
squaredDistance(const FeaturePair& pair, const Eigen::Isometry3d& T_target_source)
{
  const Eigen::Vector3d difference = T_target_source * pair.source - pair.target;
  return difference.dot(
      differenceCovariance(pair, T_target_source).llt().solve(difference));
}

Evidence
featureTerm(const std::vector<FeaturePair>& pairs,
            const Eigen::Isometry3d& T_target_source,
            const Pinhole* target_pinhole)
{
  Evidence evidence;
  for (const FeaturePair& pair : pairs) {
    const Eigen::Vector3d point = T_target_source * pair.source;
    const Eigen::Vector3d difference = point - pair.target;
    const Eigen::LLT<Eigen::Matrix3d> covariance(
        differenceCovariance(pair, T_target_source));
    const Eigen::Matrix3d whitening =
        covariance.matrixL().solve(Eigen::Matrix3d::Identity());
    const double squared = (whitening * difference).squaredNorm();
    const std::size_t tile =
        target_pinhole && point.z() > 0 ? tileOf(*target_pinhole, point) : 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d direction = whitening.row(axis).transpose();
      evidence.add(tile,
                   motionRow(point, direction),
                   direction.dot(difference),
                   robustWeight(squared));
    }
    evidence.tell(squared, 3);
  }
  return evidence;
}

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
