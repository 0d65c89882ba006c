#include "exact_entropy.h"

#include <pcl/core/exceptions.h>

#include "point_weights.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/** Larger windows than this number of bins per point are not allocated. */
constexpr double max_window = 4;

float
largestOf(const std::vector<PosedPoints>& observations)
{
  float largest = 0;
  for (const PosedPoints& observation : observations)
    largest = std::max(largest,
                       largestWeight(observation.weights, observation.points.size()));
  return largest;
}

std::int64_t
depthOf(const BinRange& range)
{
  return range.max_z - range.min_z + 1;
}

bool
areSame(const PlanarPose& a, const PlanarPose& b)
{
  return a.x == b.x && a.z == b.z && a.theta == b.theta;
}

} // namespace

CountedPoints::CountedPoints(const PosedPoints& observation,
                             float largest,
                             const MapEntropySettings& settings,
                             MapEntropyReport& report)
: bin_size_(settings.bin_size)
, minimum_(infinity, infinity)
, maximum_(-infinity, -infinity)
{
  const PointWeights weights(observation.weights, largest);
  equal_weight_ = observation.weights ? 0 : static_cast<double>(weights[0]);
  report.points += observation.points.size();
  for (std::size_t i = 0; i < observation.points.size(); ++i) {
    const Eigen::Vector3f point = observation.points[i];
    if (!point.allFinite()) {
      ++report.invalid_points;
      continue;
    }
    if (point.cwiseAbs().maxCoeff() > entropy_reach) {
      ++report.distant_points;
      continue;
    }
    WallDirection normal;
    if (settings.direction_aware) {
      normal = wallDirection(observation.points, observation.normals, i);
      report.directed_points += normal.isDirected();
    }
    if (weights[i] == 0)
      continue;
    const Eigen::Array2d place = Eigen::Array2f(point[0], point[2]).cast<double>();
    minimum_ = minimum_.min(place);
    maximum_ = maximum_.max(place);
    extent_.add(place, static_cast<double>(weights[i]));
    x_.push_back(point[0]);
    z_.push_back(point[2]);
    if (observation.weights)
      weights_.push_back(static_cast<std::uint16_t>(weights[i]));
    if (settings.direction_aware)
      directions_.push_back(normal);
  }
}

template <typename Visit>
void
CountedPoints::forEachPoint(const PlanarMotion& motion, const Visit& visit) const
{
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const Eigen::Vector2d place =
        motion.place(static_cast<double>(x_[i]), static_cast<double>(z_[i]));
    visit(i, binOf(place[0] / bin_size_), binOf(place[1] / bin_size_));
  }
}

void
CountedPoints::countAlike(const PlanarMotion& motion,
                          const BinRange& window,
                          std::vector<double>& sums) const
{
  // The quotients are positive here, so that truncation gives the bin. Multiplication is
  // faster than division; where rounding could matter, the bin is computed as above.
  const double inverse = 1 / bin_size_;
  const auto min_x = static_cast<double>(window.min_x);
  const auto min_z = static_cast<double>(window.min_z);
  const std::int64_t depth = depthOf(window);
  const double maximum = std::max(std::max(std::abs(min_x), std::abs(min_z)),
                                  static_cast<double>(sums.size()));
  const double rounding = 1e-14 * maximum;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const Eigen::Vector2d place =
        motion.place(static_cast<double>(x_[i]), static_cast<double>(z_[i]));
    const double u = place[0] * inverse - min_x;
    const double v = place[1] * inverse - min_z;
    std::int64_t x = static_cast<std::int32_t>(u);
    std::int64_t z = static_cast<std::int32_t>(v);
    const double within_x = u - static_cast<double>(x);
    const double within_z = v - static_cast<double>(z);
    if (std::min(within_x, within_z) < rounding ||
        std::max(within_x, within_z) > 1 - rounding) {
      x = binOf(place[0] / bin_size_) - window.min_x;
      z = binOf(place[1] / bin_size_) - window.min_z;
    }
    ++sums[static_cast<std::size_t>(x * depth + z)];
  }
}

BinRange
CountedPoints::rangeUnder(const PlanarMotion& motion) const
{
  BinRange range;
  for (const double x : {minimum_[0], maximum_[0]})
    for (const double z : {minimum_[1], maximum_[1]}) {
      const Eigen::Vector2d corner = motion.place(x, z) / bin_size_;
      for (const int rounding : {-1, 1})
        range.add(binOf(corner[0]) + rounding, binOf(corner[1]) + rounding);
    }
  return range;
}

int
CountedPoints::layerOf(std::size_t point, const PlanarMotion& motion) const
{
  if (directions_.empty())
    return 0;
  const WallDirection& normal = directions_[point];
  if (!normal.isDirected())
    return wall_directions;
  const double turns = motion.direction(normal.angle()) / (2 * M_PI);
  const auto layer =
      static_cast<int>(std::floor((turns - std::floor(turns)) * wall_directions));
  return std::min(layer, wall_directions - 1);
}

FilledBins
CountedPoints::fill(const PlanarPose& pose) const
{
  FilledBins filled;
  filled.pose = pose;
  if (x_.empty())
    return filled;
  const PlanarMotion motion(pose);
  const auto add = [&](std::int64_t x, std::int64_t z, int layer, double weight) {
    filled.range.add(x, z);
    filled.bins.push_back({x, z, layer, weight});
  };
  const BinRange window = rangeUnder(motion);
  const std::int64_t width = window.max_x - window.min_x + 1;
  const std::int64_t depth = depthOf(window);
  const double size = static_cast<double>(width) * static_cast<double>(depth) *
                      (directions_.empty() ? 1 : wall_directions + 1);
  if (size > max_window * static_cast<double>(x_.size())) {
    filled.bins.reserve(x_.size());
    forEachPoint(motion, [&](std::size_t i, std::int64_t x, std::int64_t z) {
      add(x, z, layerOf(i, motion), weightOf(i));
    });
    return filled;
  }
  const bool are_alike = weights_.empty() && directions_.empty();
  std::vector<double> sums(static_cast<std::size_t>(size), 0);
  if (are_alike)
    countAlike(motion, window, sums);
  else
    forEachPoint(motion, [&](std::size_t i, std::int64_t x, std::int64_t z) {
      const std::int64_t row = layerOf(i, motion) * width + x - window.min_x;
      sums[static_cast<std::size_t>(row * depth + z - window.min_z)] += weightOf(i);
    });
  const double unit = are_alike ? equal_weight_ : 1;
  std::int64_t row = 0;
  for (std::size_t first = 0; first < sums.size();
       first += static_cast<std::size_t>(depth), ++row)
    for (std::int64_t z = 0; z < depth; ++z)
      if (const double sum = sums[first + static_cast<std::size_t>(z)]; sum > 0)
        add(window.min_x + row % width,
            window.min_z + z,
            static_cast<int>(row / width),
            sum * unit);
  return filled;
}

ExactEntropyEvaluator::ExactEntropyEvaluator(
    const std::vector<PosedPoints>& observations,
    const MapEntropySettings& settings,
    const Progress& progress)
: settings_(settings)
, grid_(requireSmoothing(settings))
{
  const float largest = largestOf(observations);
  counts_.observations = observations.size();
  for (const PosedPoints& observation : observations) {
    progress.tell(0.5 * static_cast<double>(observations_.size()) /
                      static_cast<double>(observations.size()),
                  "points");
    observations_.push_back({{observation, largest, settings, counts_}, {}, {}});
  }
}

void
ExactEntropyEvaluator::fillGrid(double unit)
{
  const BinArray& array = grid_.bins();
  sums_.resize(std::max(sums_.size(),
                        static_cast<std::size_t>(layersOf(settings_) * array.layer)));
  for (const Observation& observation : observations_)
    for (const FilledBin& bin : observation.current().bins) {
      const std::int64_t at = bin.layer * array.layer +
                              (bin.x - grid_.firstX()) * array.row + bin.z -
                              grid_.firstZ();
      sums_[static_cast<std::size_t>(at)] += bin.weight;
      array.marks[at / BinArray::block] = 1;
    }
  const std::int64_t blocks = layersOf(settings_) * array.layer / BinArray::block;
  for (std::int64_t block = 0; block < blocks; ++block)
    if (array.marks[block])
      for (std::int64_t at = block * BinArray::block;
           at < (block + 1) * BinArray::block;
           ++at) {
        double& sum = sums_[static_cast<std::size_t>(at)];
        array.bins[at] = static_cast<float>(sum * unit);
        sum = 0;
      }
}

MapEntropyTerms
ExactEntropyEvaluator::evaluate(const std::vector<PlanarPose>& poses,
                                MapEntropyReport& report)
{
  if (poses.size() != observations_.size())
    throw acmap::BadArgument("each observation needs one pose");
  for (const PlanarPose& pose : poses)
    requirePlanarPose(pose);
  addCounts(counts_, report);
  counted_ = 0;
  oneapi::tbb::parallel_for(std::size_t{0}, poses.size(), [&](std::size_t i) {
    counted_ += observations_[i].move(poses[i]) ? 1 : 0;
  });
  std::vector<BinRange> ranges;
  BinRange all;
  MapExtent extent;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    ranges.push_back(observations_[i].current().range);
    all.add(ranges[i]);
    extent.add(observations_[i].points.extent(), PlanarMotion(poses[i]));
  }
  if (!canHaveGrid(ranges, extent.weight(), settings_, report))
    return {};
  grid_.begin(all);
  grid_.tell(report);
  fillGrid(unitFor(extent.weight()));
  MapEntropyTerms terms =
      grid_.finish(extent.weight() * unitFor(extent.weight()), false);
  terms.points = counts_.points - counts_.invalid_points;
  terms.dimensions = extent.dimensions(settings_.bin_size);
  remarkOnMap(terms, settings_, report);
  return terms;
}

void
ExactEntropyEvaluator::keep()
{
  for (Observation& observation : observations_)
    if (observation.tried) {
      observation.kept = std::move(observation.tried);
      observation.tried.reset();
    }
}

bool
ExactEntropyEvaluator::Observation::move(const PlanarPose& pose)
{
  if (kept && areSame(kept->pose, pose)) {
    tried.reset();
    return false;
  }
  if (tried && areSame(tried->pose, pose))
    return false;
  tried = points.fill(pose);
  return true;
}

MapEntropyTerms
exactMapEntropy(const std::vector<PosedPoints>& observations,
                const MapEntropySettings& settings,
                const Progress& progress,
                MapEntropyReport& report)
{
  std::vector<PlanarPose> poses;
  for (const PosedPoints& observation : observations)
    poses.push_back(observation.pose);
  ExactEntropyEvaluator evaluator(observations, settings, progress);
  progress.tell(0.5, "entropy");
  return evaluator.evaluate(poses, report);
}

} // namespace pcl::acmap
