#include "repetitions.h"
#include "room_planes.h"

#include <pcl/core/random.h>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::acmap::test {
namespace {

const int seeds = repetitions(20, 50);

/** Uses two thirds of the pixels, so that a hundred views only take some seconds. */
SimulatedScene
makeQuickScene(double noise)
{
  SimulatedScene scene = makeRoomCorner(noise);
  scene.sensor.points = 20000;
  return scene;
}

/** Error of a patch in its own parameters: slopes along its axes, offset at its
 * centre. */
Eigen::Vector3d
errorOf(const PlanePatch& patch, const Eigen::Vector4d& truth)
{
  const Eigen::Vector3d normal = truth.head<3>();
  const double along = normal.dot(patch.coefficients.head<3>());
  return Eigen::Vector3d(normal.dot(patch.axis_u),
                         normal.dot(patch.axis_v),
                         normal.dot(patch.center) + truth[3]) /
         -along;
}

/** The squared error normalized by the covariance: 1 on average. */
double
normalizedError(const PlanePatch& patch, const Eigen::Vector4d& truth)
{
  const Eigen::Vector3d error = errorOf(patch, truth);
  return error.dot(patch.covariance.inverse() * error) / 3;
}

/** Normalized errors of each plane over all seeds. */
class ErrorStatistics {
public:
  void
  add(const RoomPlanes& found, const SeenRoom& room)
  {
    for (std::size_t p = 0; p < found.patches.size(); ++p) {
      ASSERT_GE(found.truth[p], 0);
      const TruthPlane& truth = room.planes[static_cast<std::size_t>(found.truth[p])];
      auto& [sum, count] = errors_[truth.name];
      sum += normalizedError(found.patches[p], truth.coefficients);
      ++count;
      EXPECT_LE(found.patches[p].effective_support,
                static_cast<double>(found.patches[p].support) * 1.5);
    }
  }

  void
  expectHonest(std::size_t planes) const
  {
    EXPECT_EQ(errors_.size(), planes);
    double all = 0;
    for (const auto& [name, error] : errors_) {
      const double mean = error.first / error.second;
      EXPECT_EQ(error.second, seeds) << name;
      EXPECT_GT(mean, 0.5) << name;
      EXPECT_LT(mean, 2.0) << name;
      all += mean / static_cast<double>(errors_.size());
      testing::Test::RecordProperty("nees of " + name, std::to_string(mean));
    }
    EXPECT_GT(all, 0.5);
    EXPECT_LT(all, 2.0);
  }

private:
  std::map<std::string, std::pair<double, int>> errors_;
};

/** Adds noise along the rays: independent noise, and noise shared by all points of a
 * cube. */
void
addSharedNoise(
    SeenRoom& room, double own, double shared, double edge, std::uint64_t seed)
{
  Random random(seed);
  for (PointXYZRGBNormalView& point : *room.cloud) {
    std::uint64_t cube = seed;
    for (const float coordinate : {point.x, point.y, point.z})
      cube = Random(cube + static_cast<std::uint64_t>(coordinate / edge + 1e4)).bits();
    const double off = own * random.normal() + shared * Random(cube).normal();
    const Eigen::Vector3f ray =
        (point.getVector3fMap() - room.viewpoints[0]).normalized();
    point.getVector3fMap() += static_cast<float>(off) * ray;
  }
}

TEST(PlaneCovariance, isHonestForIndependentNoise)
{
  ErrorStatistics errors;
  const SimulatedScene scene = makeQuickScene(0.01);
  for (int seed = 1; seed <= seeds; ++seed) {
    const SeenRoom room = see(scene, static_cast<std::uint64_t>(seed));
    errors.add(findPlanes(room), room);
  }
  errors.expectHonest(3);
}

/** Stereo noise is shared by a patch of pixels. */
TEST(PlaneCovariance, isHonestForNoiseThatNeighboursShare)
{
  ErrorStatistics errors;
  const SimulatedScene scene = makeQuickScene(1e-6);
  for (int s = 1; s <= seeds; ++s) {
    const auto seed = static_cast<std::uint64_t>(s);
    SeenRoom room = see(scene, seed);
    addSharedNoise(room, 0.01, 0.01, 0.05, seed);
    errors.add(findPlanes(room), room);
  }
  errors.expectHonest(3);
}

/** Twice the noise along the rays gives four times the covariance. The median is
 * tested, because a plane of which half of the points are clean may be fitted to these
 * only or to all points. */
TEST(PlaneCovariance, growsWithTheNoise)
{
  constexpr std::uint64_t rooms = 5;
  std::map<std::string, std::vector<double>> before, offsets;
  for (const double noise : {0.005, 0.01}) {
    before = std::move(offsets);
    offsets.clear();
    for (std::uint64_t seed = 1; seed <= rooms; ++seed) {
      const SeenRoom room = see(makeRoomCorner(noise), seed);
      const RoomPlanes found = findPlanes(room);
      for (std::size_t p = 0; p < found.patches.size(); ++p) {
        const double offset = std::sqrt(found.patches[p].covariance(2, 2));
        EXPECT_LT(offset, 0.001) << "metres";
        offsets[room.planes[static_cast<std::size_t>(found.truth[p])].name].push_back(
            offset);
      }
    }
    ASSERT_EQ(offsets.size(), 3U);
  }
  for (auto& [name, values] : offsets) {
    ASSERT_EQ(values.size(), rooms) << name;
    ASSERT_EQ(before[name].size(), rooms) << name;
    std::sort(values.begin(), values.end());
    std::sort(before[name].begin(), before[name].end());
    EXPECT_NEAR(values[rooms / 2] / before[name][rooms / 2], 2, 0.5) << name;
  }
}

TEST(PlaneCovariance, isSymmetricAndPositive)
{
  const RoomPlanes found = findPlanes(see(makeRoomCorner(0.01), 3));
  ASSERT_EQ(found.patches.size(), 3U);
  for (const PlanePatch& patch : found.patches) {
    const Eigen::Matrix3d& c = patch.covariance;
    EXPECT_LT((c - c.transpose()).norm(), 1e-9 * c.norm());
    EXPECT_GT(c(0, 0), 0);
    EXPECT_GT(c(0, 0) * c(1, 1) - c(0, 1) * c(1, 0), 0);
    EXPECT_GT(c.determinant(), 0);
    EXPECT_LE(c(0, 0), c(1, 1)) << "axis_u is the longer one";
  }
}

} // namespace
} // namespace pcl::acmap::test
