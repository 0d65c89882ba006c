#include "motion_fit/pair_moments.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

/** A valid pair, relative to the first one: points far from the origin keep their
 * digits, and coincident points are exactly equal. */
struct WeighedPair {
  Eigen::Vector3d source, target;
  double weight = 0;
};

std::vector<WeighedPair>
countingPairs(const std::vector<Eigen::Vector3d>& source,
              const std::vector<Eigen::Vector3d>& target,
              const std::vector<double>& weights)
{
  std::vector<WeighedPair> pairs;
  double maximum = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (!doesCount(source, target, weights, i))
      continue;
    pairs.push_back({source[i], target[i], weightOf(weights, i)});
    maximum = std::max(maximum, pairs.back().weight);
  }
  double sum = 0;
  for (WeighedPair& pair : pairs)
    sum += pair.weight /= maximum;
  for (WeighedPair& pair : pairs)
    pair.weight /= sum;
  return pairs;
}

/** Moves one cloud so that its centroid is the origin; returns the previous centroid.
 */
Eigen::Vector3d
centre(std::vector<WeighedPair>& pairs, Eigen::Vector3d WeighedPair::*point)
{
  const Eigen::Vector3d first = pairs.front().*point;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (WeighedPair& pair : pairs) {
    pair.*point -= first;
    mean += pair.weight * (pair.*point);
  }
  for (WeighedPair& pair : pairs)
    pair.*point -= mean;
  return first + mean;
}

} // namespace

bool
doesCount(const std::vector<Eigen::Vector3d>& source,
          const std::vector<Eigen::Vector3d>& target,
          const std::vector<double>& weights,
          std::size_t pair)
{
  const double weight = weightOf(weights, pair);
  return std::isfinite(weight) && weight > 0 &&
         std::isfinite(source[pair].squaredNorm()) &&
         std::isfinite(target[pair].squaredNorm());
}

PairMoments
pairMoments(const std::vector<Eigen::Vector3d>& source,
            const std::vector<Eigen::Vector3d>& target,
            const std::vector<double>& weights)
{
  PairMoments moments;
  std::vector<WeighedPair> pairs = countingPairs(source, target, weights);
  moments.source = moments.target = Eigen::Vector3d::Zero();
  moments.spread = moments.cross = Eigen::Matrix3d::Zero();
  if (pairs.empty())
    return moments;
  moments.source = centre(pairs, &WeighedPair::source);
  moments.target = centre(pairs, &WeighedPair::target);
  for (const WeighedPair& pair : pairs)
    moments.scale = std::max({moments.scale,
                              pair.source.lpNorm<Eigen::Infinity>(),
                              pair.target.lpNorm<Eigen::Infinity>()});
  if (moments.scale == 0)
    moments.scale = 1;
  for (const WeighedPair& pair : pairs) {
    const Eigen::Vector3d a = pair.source / moments.scale;
    const Eigen::Vector3d b = pair.target / moments.scale;
    moments.spread += pair.weight * a * a.transpose();
    moments.target_spread += pair.weight * b.squaredNorm();
    moments.cross += pair.weight * b * a.transpose();
  }
  return moments;
}

} // namespace pcl::acmap
