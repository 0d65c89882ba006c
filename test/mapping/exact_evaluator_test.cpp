#include "entropy/exact_entropy.h"
#include "rectification_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pcl::acmap::test {
namespace {

/** The map as it is given to the kernels; its clouds must outlive it. */
std::vector<PosedPoints>
posedPoints(const PosedClouds& map)
{
  std::vector<PosedPoints> observations;
  for (std::size_t i = 0; i < map.clouds.size(); ++i) {
    const PointCloud<PointNormal>& cloud = *map.clouds[i];
    PosedPoints seen;
    seen.points = {&cloud.front().x, sizeof(PointNormal), cloud.size()};
    seen.normals = {&cloud.front().normal_x, sizeof(PointNormal), cloud.size()};
    seen.pose = map.poses[i];
    observations.push_back(seen);
  }
  return observations;
}

double
freshEnergy(PosedClouds map,
            const std::vector<PlanarPose>& poses,
            const MapEntropySettings& settings)
{
  map.poses = poses;
  MapEntropyReport report;
  return exactMapEntropy(posedPoints(map), settings, Progress(), report).total;
}

TEST(ExactEntropyEvaluator, movedObservationsAloneAreCountedAgainWithoutADifference)
{
  const PosedClouds map = makeRoomViews(4, 3000, 61);
  for (const bool directions : {false, true}) {
    MapEntropySettings settings;
    settings.direction_aware = directions;
    ExactEntropyEvaluator evaluator(posedPoints(map), settings, Progress());
    std::vector<PlanarPose> kept = map.poses;
    for (int i = 0; i < 40; ++i) {
      std::vector<PlanarPose> poses = kept;
      for (std::size_t t = 0; t < poses.size(); ++t)
        if ((i + static_cast<int>(t)) % 3 == 0)
          poses[t] = moved(poses[t], {0.013 * i, -0.2, 0.01 * i});
      if (i == 20)
        poses[1].x += 30;
      MapEntropyReport report;
      EXPECT_EQ(evaluator.evaluate(poses, report).total,
                freshEnergy(map, poses, settings))
          << i;
      if (i % 4 == 1) {
        evaluator.keep();
        kept = poses;
      }
    }
  }
}

TEST(ExactEntropyEvaluator, keptPosesAreNotCountedAgain)
{
  const PosedClouds map = makeRoomViews(4, 100, 63);
  ExactEntropyEvaluator evaluator(posedPoints(map), {}, Progress());
  MapEntropyReport report;
  const auto countedFor = [&](const std::vector<PlanarPose>& poses) {
    evaluator.evaluate(poses, report);
    return evaluator.counted();
  };
  EXPECT_EQ(countedFor(map.poses), 4U) << "for the first time";
  EXPECT_EQ(countedFor(map.poses), 0U);
  evaluator.keep();
  std::vector<PlanarPose> tried = map.poses;
  tried[1].x += 0.1;
  tried[3].theta += 0.1;
  EXPECT_EQ(countedFor(tried), 2U);
  EXPECT_EQ(countedFor(map.poses), 0U) << "as they are kept";
  EXPECT_EQ(countedFor(tried), 2U);
  evaluator.keep();
  EXPECT_EQ(countedFor(tried), 0U);
  EXPECT_EQ(countedFor(map.poses), 2U) << "no more than one pose is kept";
}

TEST(ExactEntropyEvaluator, orderAndDensityOfThePointsDoNotMatter)
{
  const PosedClouds map = makeRoomViews(3, 5000, 62);
  const double wanted = freshEnergy(map, map.poses, {});
  for (const auto& cloud : map.clouds)
    std::reverse(cloud->begin(), cloud->end());
  EXPECT_EQ(freshEnergy(map, map.poses, {}), wanted);
  // In large bins many points share one, in small ones each has its own.
  for (const double bin : {0.01, 0.1, 2.0}) {
    MapEntropySettings settings;
    settings.bin_size = bin;
    settings.smoothing = bin;
    NaiveEntropySettings naive;
    naive.bin = naive.sigma = bin;
    EXPECT_NEAR(
        freshEnergy(map, map.poses, settings), naiveEntropy(map, naive).total, 1e-5);
  }
}

} // namespace
} // namespace pcl::acmap::test
