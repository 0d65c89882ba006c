#include "bench.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/planar_pose.h>
#include <pcl/mapping/impl/map_entropy_kernel.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>

#include <Eigen/Core>

namespace pcl::acmap::bench {
namespace {

/** \brief Observations with normals and true poses, to compute the entropy of their
 * map. */
struct EntropyMap {
  std::vector<std::vector<Eigen::Vector3f>> points;  ///< metres, sensor frames
  std::vector<std::vector<Eigen::Vector3f>> normals; ///< unit
  std::vector<PlanarPose> poses;

  std::size_t
  size() const
  {
    std::size_t sum = 0;
    for (const auto& cloud : points)
      sum += cloud.size();
    return sum;
  }

  std::vector<PosedPoints>
  observations() const
  {
    std::vector<PosedPoints> all;
    constexpr std::size_t stride = sizeof(Eigen::Vector3f);
    for (std::size_t i = 0; i < points.size(); ++i)
      all.push_back({{points[i].data(), stride, points[i].size()},
                     {normals[i].data(), stride, normals[i].size()},
                     poses[i],
                     nullptr});
    return all;
  }
};

/** \brief All views of the simulated corridor, with the normals of its planes. */
EntropyMap
makeCorridorMap()
{
  const SimulatedScene scene = standardScene("corridor");
  const std::vector<TruthPlane> planes = scene.geometry.planes();
  EntropyMap map;
  for (std::size_t view = 0; view < scene.views.size(); ++view) {
    map.poses.push_back(planarPartOf(scene.views[0].inverse() * scene.views[view]));
    auto& points = map.points.emplace_back();
    auto& normals = map.normals.emplace_back();
    const Eigen::Matrix3d to_camera = scene.views[view].linear().transpose();
    for (const ObservationPixel& pixel : observe(scene, view, 1).pixels) {
      if (!std::isfinite(pixel.x))
        continue;
      points.emplace_back(pixel.x, pixel.y, pixel.z);
      normals.emplace_back(
          pixel.label == 0
              ? Eigen::Vector3f::Constant(std::nanf(""))
              : Eigen::Vector3f(
                    (to_camera * planes[pixel.label - 1].coefficients.head<3>())
                        .cast<float>()));
    }
  }
  return map;
}

/** \brief The minimum work of any entropy of points: transforms each point by its pose
 * and computes its bin, from arrays of floats, eight at once if the processor supports
 * it. */
class EntropyPass {
public:
  EntropyPass(const EntropyMap& map, double bin_size);

  /** \brief Computes all bins.
   * \return a value that depends on all bins, so that nothing is optimized away */
  std::int64_t
  find();

  /** \brief Computes all bins and counts their points: the plain histogram. */
  std::int64_t
  count();

private:
  struct Observation {
    std::vector<float> x, z; ///< in bins
    PlanarPose pose;
  };

  template <typename Visit>
  void
  forEachChunk(const Visit& visit);

  std::vector<Observation> observations_;
  float x0_, z0_; ///< first bin
  std::int32_t row_;
  double bin_size_;
  std::vector<std::uint32_t> counts_;
};

/** x' = c x + s z + x0 and z' = c z - s x + z0, in bins. */
struct PassMotion {
  float c, s, x0, z0;
  std::int32_t row;
};

constexpr std::size_t chunk = 1024;

#if defined(__x86_64__)
__attribute__((target_clones("avx2", "default")))
#endif
void
findBins(const float* x,
         const float* z,
         std::size_t size,
         const PassMotion& motion,
         std::int32_t* bins)
{
  for (std::size_t i = 0; i < size; ++i) {
    const auto u =
        static_cast<std::int32_t>(motion.c * x[i] + motion.s * z[i] + motion.x0);
    const auto v =
        static_cast<std::int32_t>(motion.c * z[i] - motion.s * x[i] + motion.z0);
    bins[i] = u * motion.row + v;
  }
}

PassMotion
motionOf(const PlanarPose& pose, double bin_size)
{
  return {static_cast<float>(std::cos(pose.theta)),
          static_cast<float>(std::sin(pose.theta)),
          static_cast<float>(pose.x / bin_size),
          static_cast<float>(pose.z / bin_size),
          0};
}

EntropyPass::EntropyPass(const EntropyMap& map, double bin_size)
: bin_size_(bin_size)
{
  Eigen::Array2f minimum = Eigen::Array2f::Constant(std::numeric_limits<float>::max());
  Eigen::Array2f maximum = -minimum;
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    Observation& observation = observations_.emplace_back();
    observation.pose = map.poses[i];
    const PassMotion motion = motionOf(map.poses[i], bin_size);
    for (const Eigen::Vector3f& point : map.points[i]) {
      const float x = point[0] / static_cast<float>(bin_size);
      const float z = point[2] / static_cast<float>(bin_size);
      observation.x.push_back(x);
      observation.z.push_back(z);
      const Eigen::Array2f place(motion.c * x + motion.s * z + motion.x0,
                                 motion.c * z - motion.s * x + motion.z0);
      minimum = minimum.min(place);
      maximum = maximum.max(place);
    }
  }
  x0_ = std::floor(minimum[0]) - 1;
  z0_ = std::floor(minimum[1]) - 1;
  row_ = static_cast<std::int32_t>(maximum[1] - z0_) + 2;
  counts_.resize(static_cast<std::size_t>(row_) *
                 (static_cast<std::size_t>(maximum[0] - x0_) + 2));
}

template <typename Visit>
void
EntropyPass::forEachChunk(const Visit& visit)
{
  std::int32_t bins[chunk];
  for (const Observation& observation : observations_) {
    PassMotion motion = motionOf(observation.pose, bin_size_);
    motion.x0 -= x0_;
    motion.z0 -= z0_;
    motion.row = row_;
    for (std::size_t first = 0; first < observation.x.size(); first += chunk) {
      const std::size_t size = std::min(chunk, observation.x.size() - first);
      findBins(&observation.x[first], &observation.z[first], size, motion, bins);
      visit(bins, size);
    }
  }
}

std::int64_t
EntropyPass::find()
{
  std::int64_t sum = 0;
  forEachChunk(
      [&](const std::int32_t* bins, std::size_t size) { sum += bins[size / 2]; });
  return sum;
}

std::int64_t
EntropyPass::count()
{
  std::fill(counts_.begin(), counts_.end(), 0);
  forEachChunk([&](const std::int32_t* bins, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      ++counts_[static_cast<std::size_t>(bins[i])];
  });
  return counts_[counts_.size() / 2];
}

std::vector<EntropyCells>
aggregateAll(const std::vector<PosedPoints>& observations,
             const MapEntropySettings& settings)
{
  std::vector<EntropyCells> cells;
  for (const PosedPoints& one : observations)
    cells.push_back(aggregateCells(one.points, one.normals, settings, one.weights));
  return cells;
}

/** Targets for a map; \ref no_reach if there is no target. */
struct EntropyReach {
  double entropy_ms, passes, gradient_times;
};

/** CPU seconds, one thread, medians of interleaved rounds; slow ones get fewer rounds. */
void
printEntropy(const EntropyMap& map,
             const MapEntropySettings& settings,
             const EntropyReach& reach)
{
  constexpr std::size_t rounds = 25, slow_rounds = 5;
  const std::vector<PosedPoints> observations = map.observations();
  EntropyPass plain(map, settings.bin_size);
  std::vector<double> pass, histogram, cells, entropy, gradient, exact;
  MapEntropyReport report;
  double fast_bits = 0, exact_bits = 0;
  std::int64_t sum = 0;
  std::vector<EntropyCells> aggregated;
  for (std::size_t round = 0; round < slow_rounds; ++round) {
    cells.push_back(
        measureThread([&] { aggregated = aggregateAll(observations, settings); }));
    MapEntropyReport unused;
    exact.push_back(measureThread([&] {
      exact_bits = exactMapEntropy(observations, settings, Progress(), unused).total;
    }));
  }
  MapEntropyEvaluator evaluator(aggregated, settings);
  std::vector<Eigen::Vector3d> slopes;
  for (std::size_t round = 0; round < rounds; ++round) {
    report = {};
    pass.push_back(measureThread([&] { sum += plain.find(); }));
    histogram.push_back(measureThread([&] { sum += plain.count(); }));
    entropy.push_back(measureThread(
        [&] { fast_bits = evaluator.evaluate(map.poses, report).total; }));
    report = {};
    gradient.push_back(
        measureThread([&] { evaluator.evaluate(map.poses, report, &slopes); }));
  }
  if (sum == 1)
    std::cerr << "a rare sum\n"; // prevents the compiler from removing the pass
  Row() << (settings.direction_aware ? "corridor, 9 layers" : "corridor") << map.size()
        << report.cells << report.bins_x * report.bins_z * report.layers
        << figure(milli * median(pass), 2) << figure(milli * median(histogram), 2)
        << atMost(median(cells), 0.5, 2)
        << atMost(milli * median(entropy), reach.entropy_ms, 2)
        << atMost(median(entropy) / median(pass), reach.passes, 2)
        << figure(milli * median(gradient), 2)
        << atMost(median(gradient) / median(entropy), reach.gradient_times, 2)
        << figure(milli * median(exact), 0) << figure(fast_bits - exact_bits, 4);
}

const Section entropy_section("entropy", [] {
  const EntropyMap map = makeCorridorMap();
  printHead("map | points | cells | bins | finding bins, ms | histogram, ms | making "
            "cells, s | entropy, ms | of finding bins | with gradient, ms | times the "
            "entropy | exact, ms | fast - exact, bits");
  withThreads(1, [&] {
    MapEntropySettings settings;
    settings.bin_size = settings.smoothing = 0.05;
    printEntropy(map, settings, {4, 0.2, 2.5});
    settings.direction_aware = true;
    printEntropy(map, settings, {no_reach, no_reach, no_reach});
  });
});

} // namespace
} // namespace pcl::acmap::bench
