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
  double entropy_ms, gradient_times;
};

/** CPU seconds, one thread, medians of interleaved rounds; slow ones get fewer rounds. */
void
printEntropy(const EntropyMap& map,
             const MapEntropySettings& settings,
             const EntropyReach& reach)
{
  constexpr std::size_t rounds = 25, slow_rounds = 5;
  const std::vector<PosedPoints> observations = map.observations();
  std::vector<double> cells, entropy, gradient, exact;
  MapEntropyReport report;
  double fast_bits = 0, exact_bits = 0;
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
    entropy.push_back(measureThread(
        [&] { fast_bits = evaluator.evaluate(map.poses, report).total; }));
    report = {};
    gradient.push_back(
        measureThread([&] { evaluator.evaluate(map.poses, report, &slopes); }));
  }
  Row() << (settings.direction_aware ? "corridor, 9 layers" : "corridor") << map.size()
        << report.cells << report.bins_x * report.bins_z * report.layers
        << atMost(median(cells), 0.5, 2)
        << atMost(milli * median(entropy), reach.entropy_ms, 2)
        << figure(milli * median(gradient), 2)
        << atMost(median(gradient) / median(entropy), reach.gradient_times, 2)
        << figure(milli * median(exact), 0) << figure(fast_bits - exact_bits, 4);
}

const Section entropy_section("entropy", [] {
  const EntropyMap map = makeCorridorMap();
  printHead("map | points | cells | bins | making cells, s | entropy, ms | with "
            "gradient, ms | times the entropy | exact, ms | fast - exact, bits");
  withThreads(1, [&] {
    MapEntropySettings settings;
    settings.bin_size = settings.smoothing = 0.05;
    printEntropy(map, settings, {4, 2.5});
    settings.direction_aware = true;
    printEntropy(map, settings, {no_reach, no_reach});
  });
});

} // namespace
} // namespace pcl::acmap::bench
