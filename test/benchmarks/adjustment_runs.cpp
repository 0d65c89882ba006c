#include "adjustment_runs.h"

#include "bench.h"

#include <pcl/conversions.h>
#include <pcl/core/random.h>
#include <pcl/core/trajectory_error.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/simulation/simulated_observation.h>

#include <cstdlib>
#include <numeric>

namespace pcl::acmap::bench {
namespace {

constexpr double turn_of_view = 0.2 * degree; // radians
constexpr double length_share = 0.01;

OdometryNoise
noiseOf(const FreeDrift& drift)
{
  const double level = drift.told * (drift.level > 0 ? drift.level : 1);
  return {1e-4 * level, length_share * level, turn_of_view * level, 0};
}

double
lengthBetweenEnds(const std::vector<Eigen::Isometry3d>& poses)
{
  return (poses.back().translation() - poses.front().translation()).norm();
}

} // namespace

AdjustmentScene
makeAdjustmentScene(const SimulatedScene& scene, std::uint64_t noise_seed)
{
  AdjustmentScene result;
  result.name = scene.name;
  result.truth = scene.views;
  for (std::size_t view = 0; view < scene.views.size(); ++view) {
    const auto cloud = std::make_shared<PointCloud<PointXYZRGBSigma>>();
    fromPCLPointCloud2(cloudOf(observe(scene, view, noise_seed)), *cloud);
    result.clouds.push_back(cloud);
  }
  return result;
}

std::vector<Eigen::Isometry3d>
driftedFreely(const std::vector<Eigen::Isometry3d>& truth,
              const FreeDrift& drift,
              std::uint64_t seed)
{
  constexpr double rare = 0.1, strong = 5;
  Random random(seed);
  std::vector<Eigen::Isometry3d> poses{truth.front()};
  for (std::size_t i = 1; i < truth.size(); ++i) {
    Eigen::Isometry3d motion = truth[i - 1].inverse() * truth[i];
    double level = drift.level;
    if (drift.heavy_tailed && random.uniform() < rare)
      level *= strong;
    const double length = level * length_share * motion.translation().norm();
    Eigen::Vector3d turn, way;
    for (int k = 0; k < 3; ++k) {
      turn[k] = level * turn_of_view * random.normal() + drift.turn_bias * degree;
      way[k] = length * random.normal();
    }
    if (turn.norm() > 0)
      motion.rotate(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
    motion.translation() += way;
    Eigen::Isometry3d pose = poses.back() * motion;
    pose.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
    poses.push_back(pose);
  }
  return poses;
}

AdjustmentRun
adjust(const AdjustmentScene& scene,
       const std::vector<Eigen::Isometry3d>& given,
       const FreeDrift& drift,
       const std::vector<Revisit>& revisits)
{
  PlaneAdjustment<PointXYZRGBSigma> adjustment;
  adjustment.setNumberOfThreads(1);
  adjustment.setOdometryNoise(noiseOf(drift));
  for (std::size_t i = 0; i < given.size(); ++i)
    adjustment.addPointCloud(scene.clouds[i], given[i]);
  for (const Revisit& revisit : revisits)
    adjustment.addRevisit(revisit.earlier,
                          revisit.later,
                          revisit.estimate.T_target_source,
                          revisit.estimate.covariance);
  AdjustmentRun run;
  run.seconds = measureCost([&] { adjustment.compute(); }).cpu;
  for (std::size_t i = 0; i < given.size(); ++i) {
    run.found.push_back(adjustment.getPose(i));
    run.height = std::max(
        run.height,
        std::abs(run.found[i].translation().y() - scene.truth[i].translation().y()));
  }
  run.report = adjustment.getReport();
  run.before = absoluteTrajectoryError(given, scene.truth).unaligned;
  run.after = absoluteTrajectoryError(run.found, scene.truth).unaligned;
  const double length = lengthBetweenEnds(scene.truth);
  run.length_before = 100 * (lengthBetweenEnds(given) / length - 1);
  run.length_after = 100 * (lengthBetweenEnds(run.found) / length - 1);
  return run;
}

AdjustmentRun
rectifyAndAdjust(const AdjustmentScene& scene,
                 const RectificationMap& map,
                 const std::vector<Eigen::Isometry3d>& given,
                 const FreeDrift& drift)
{
  AdjustmentRun first = adjust(scene, given, drift);
  if (first.report.outcome == AdjustmentOutcome::Adjusted ||
      first.report.outcome == AdjustmentOutcome::Kept)
    return first;
  EntropyRectification<PointNormal> rectification;
  rectification.setNumberOfThreads(1);
  rectification.setBinSize(map.bin_size);
  rectification.setOdometryNoise(noiseOf(drift));
  for (std::size_t i = 0; i < given.size(); ++i)
    rectification.addPointCloud(map.clouds[i], given[i], map.weights[i]);
  const double seconds = measureCost([&] { rectification.compute(); }).cpu;
  std::vector<Eigen::Isometry3d> rectified;
  for (std::size_t i = 0; i < given.size(); ++i)
    rectified.push_back(rectification.getPose(i));
  AdjustmentRun run = adjust(scene, rectified, drift);
  run.before = absoluteTrajectoryError(given, scene.truth).unaligned;
  run.length_before =
      100 * (lengthBetweenEnds(given) / lengthBetweenEnds(scene.truth) - 1);
  run.seconds += seconds + first.seconds;
  return run;
}

std::vector<std::uint64_t>
driftSeeds()
{
  const char* const count = std::getenv("ACMAP_DRIFT_SEEDS");
  std::vector<std::uint64_t> seeds(count ? std::strtoul(count, nullptr, 10) : 10);
  std::iota(seeds.begin(), seeds.end(), 11);
  return seeds;
}

} // namespace pcl::acmap::bench
