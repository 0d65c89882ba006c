#include "plane_matches.h"

#include "bench.h"
#include "simulated_clouds.h"

#include <numeric>
#include <set>

namespace pcl::acmap::bench {

PlaneCase
makePlaneCase(const SimulatedCloud& cloud)
{
  PlaneCase result;
  result.name = cloud.name;
  result.input =
      makePlaneInput(plainPoints(cloud), cloud.sensorOrigins(), cloud.merged.view);
  result.truth.planes = cloud.merged.planes;
  result.truth.labels.reserve(cloud.size());
  for (const std::uint32_t label : cloud.merged.label)
    result.truth.labels.push_back(static_cast<std::int32_t>(label) - 1);
  return result;
}

bool
isMainPlane(const TruthPlane& plane)
{
  static const std::set<std::string> names{
      "floor", "ceiling", "left wall", "right wall", "near end", "far end"};
  return names.count(plane.name) > 0;
}

bool
isDoorPlane(const TruthPlane& plane)
{
  return plane.name == "doors left" || plane.name == "doors right";
}

PlaneOverlaps::PlaneOverlaps(const std::vector<std::int32_t>& truth,
                             std::size_t truth_planes,
                             const std::vector<std::int32_t>& found,
                             std::size_t found_planes)
: truth_sizes_(truth_planes)
, found_sizes_(found_planes)
, common_(truth_planes * found_planes)
{
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto t = static_cast<std::size_t>(truth[i]);
    const auto f = static_cast<std::size_t>(found[i]);
    if (truth[i] >= 0)
      ++truth_sizes_[t];
    if (found[i] >= 0)
      ++found_sizes_[f];
    if (truth[i] >= 0 && found[i] >= 0)
      ++common_[f * truth_planes + t];
  }
}

std::size_t
PlaneOverlaps::labelledSize(std::size_t found) const
{
  const auto row = common_.begin() + static_cast<std::ptrdiff_t>(found * truths());
  return std::accumulate(
      row, row + static_cast<std::ptrdiff_t>(truths()), std::size_t{0});
}

std::int32_t
PlaneOverlaps::majority(std::size_t found) const
{
  if (labelledSize(found) == 0)
    return -1;
  const auto row = common_.begin() + static_cast<std::ptrdiff_t>(found * truths());
  const auto maximum =
      std::max_element(row, row + static_cast<std::ptrdiff_t>(truths()));
  return static_cast<std::int32_t>(maximum - row);
}

namespace {

MatchDeviation
deviationOf(const Eigen::Vector4d& found,
            const Eigen::Vector4d& truth,
            const Eigen::Vector3d& centroid)
{
  const Eigen::Vector3d normal = truth.head<3>();
  const Eigen::Vector3d place = centroid - (normal.dot(centroid) + truth[3]) * normal;
  const Eigen::Vector3d found_normal = found.head<3>();
  const double sine = normal.cross(found_normal).norm();
  return {std::atan2(sine, std::abs(normal.dot(found_normal))) / degree,
          std::abs(found_normal.dot(place) + found[3])};
}

} // namespace

PlaneMatches
matchPlanes(const PlaneCase& plane_case,
            const FoundPlanes& found,
            const PlaneOverlaps& overlaps,
            const MatchLimits& limits)
{
  const std::vector<TruthPlane>& planes = plane_case.truth.planes;
  const std::vector<std::int32_t>& labels = plane_case.truth.labels;
  std::vector<Eigen::Vector3d> centroids(planes.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] >= 0)
      centroids[static_cast<std::size_t>(labels[i])] +=
          (*plane_case.input.points)[i].getVector3fMap().cast<double>();
  for (std::size_t t = 0; t < centroids.size(); ++t)
    centroids[t] /=
        static_cast<double>(std::max<std::size_t>(overlaps.truthSize(t), 1));
  PlaneMatches matches;
  matches.finder.assign(planes.size(), -1);
  matches.deviation.resize(planes.size());
  for (std::size_t f = 0; f < found.planes.size(); ++f) {
    const auto t = static_cast<std::size_t>(std::max(overlaps.majority(f), 0));
    const MatchDeviation deviation =
        deviationOf(found.planes[f], planes[t].coefficients, centroids[t]);
    const bool is_of_truth =
        2 * overlaps.common(f, t) >= std::max<std::size_t>(overlaps.foundSize(f), 1);
    if (!is_of_truth || deviation.angle > limits.angle ||
        deviation.offset > limits.offset) {
      ++matches.spurious;
      matches.astray += is_of_truth;
      continue;
    }
    std::int32_t& finder = matches.finder[t];
    matches.duplicates += finder >= 0;
    if (finder < 0 ||
        overlaps.common(f, t) > overlaps.common(static_cast<std::size_t>(finder), t)) {
      finder = static_cast<std::int32_t>(f);
      matches.deviation[t] = deviation;
    }
  }
  return matches;
}

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
