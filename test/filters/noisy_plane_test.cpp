#include "consolidation_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double noise = 0.01;

struct NoisyPlaneCase {
  double inclination;
  double density;
  double voxel;
};

/** A square of 2 m with noise of 1 cm, observed from (0.3, -0.2, 5) or from below
 * it. */
class NoisyPlane : public testing::TestWithParam<NoisyPlaneCase> {
protected:
  NoisyPlane()
  {
    Random random(21);
    cloud_.viewpoints = {{0.3F, -0.2F, 5.0F}, {0.3F, -0.2F, -5.0F}};
    cloud_.addPatch(patch_, GetParam().density, noise, random, 0);
  }

  const Patch patch_ = squarePatch(2, GetParam().inclination);
  NoisyCloud cloud_;
};

TEST_P(NoisyPlane, pointsLieOnThePlane)
{
  const double voxel = GetParam().voxel;
  const Consolidated found = consolidate(cloud_, voxel);
  const double residual = found.report.residual;
  // the faces of the windows cut an inclined plane unevenly
  const double cut = GetParam().inclination > 0 ? noise * noise / (2.5 * voxel) : 0;
  std::size_t points = 0, within = 0;
  double largest = 0;
  for (const MapPoint& point : found.cloud) {
    if (insetIn(patch_, placeOf(point)) < 2.5 * voxel)
      continue;
    const double off = std::abs(patch_.depthOf(placeOf(point)));
    ++points;
    within += off <= 3 * residual + cut;
    largest = std::max(largest, off);
  }
  ASSERT_GT(points, 200U);
  EXPECT_GT(static_cast<double>(within), 0.985 * static_cast<double>(points));
  EXPECT_LT(largest, 0.7 * noise) << "a spike";
  EXPECT_LT(residual, noise / 5);
  EXPECT_NEAR(found.report.sigma, noise, 0.15 * noise);
}

TEST_P(NoisyPlane, normalsAreThoseOfThePlane)
{
  const double voxel = GetParam().voxel;
  const Consolidated found = consolidate(cloud_, voxel);
  const SheetFit fit = fitOf(found.cloud, patch_, voxel, 0.5, 2.5 * voxel);
  // uncertainty of a plane's slope in 5 x 5 voxels, or 3 x 3 if these are thin
  EXPECT_LT(fit.median_angle, std::max(degree, 5 * found.report.residual / voxel / 2));
  EXPECT_NEAR(fit.mean, 0, 0.1 * noise);
  EXPECT_GT(fit.coverage, 0.7);
  EXPECT_LT(fit.coverage, 1.3);
}

TEST_P(NoisyPlane, normalsLookToTheSensor)
{
  for (const int view : {0, 1}) {
    std::fill(cloud_.view.begin(), cloud_.view.end(), view);
    for (const MapPoint& point : consolidate(cloud_, GetParam().voxel).cloud) {
      EXPECT_NEAR(normalOf(point).norm(), 1, 1e-5);
      EXPECT_GT(normalOf(point).cast<float>().dot(
                    cloud_.viewpoints[static_cast<std::size_t>(view)] -
                    point.getVector3fMap()),
                0);
    }
  }
}

TEST_P(NoisyPlane, curvatureIsTheShareOfTheNoise)
{
  const double voxel = GetParam().voxel;
  const double across = noise * noise;
  const double along = std::pow(5 * voxel, 2) / 12;
  const double flat = across / (across + 2 * along);
  std::size_t points = 0, within = 0;
  for (const MapPoint& point : consolidate(cloud_, voxel).cloud) {
    if (insetIn(patch_, placeOf(point)) < 2.5 * voxel)
      continue;
    ++points;
    within += point.curvature > flat / 2 && point.curvature < 3.5 * flat;
  }
  EXPECT_GT(static_cast<double>(within), 0.95 * static_cast<double>(points));
}

INSTANTIATE_TEST_SUITE_P(Consolidation,
                         NoisyPlane,
                         testing::Values(NoisyPlaneCase{0, 10000, 0.1},
                                         NoisyPlaneCase{0, 3000, 0.06},
                                         NoisyPlaneCase{0.35, 10000, 0.05},
                                         NoisyPlaneCase{0.6, 3000, 0.08},
                                         NoisyPlaneCase{0.785, 30000, 0.05}));

TEST(NoisyPlaneTail, leavesHardlyASpike)
{
  // voxels of three sigma: points in the tail of the noise get voxels of their own
  for (const auto& [density, largest_share] :
       {std::pair{3000.0, 3e-3}, std::pair{30000.0, 1e-4}}) {
    std::size_t spikes = 0, points = 0;
    for (int offset = 0; offset < 4; ++offset) {
      Patch patch = squarePatch(2, 0.785);
      patch.corner += patch.normal() * (0.0075 * offset);
      NoisyCloud cloud;
      cloud.viewpoints = {{0.3F, -0.2F, 5.0F}};
      Random random(31 + static_cast<std::uint64_t>(offset));
      cloud.addPatch(patch, density, noise, random, 0);
      for (const MapPoint& point : consolidate(cloud, 0.03).cloud) {
        if (insetIn(patch, placeOf(point)) < 0.1)
          continue;
        ++points;
        spikes += std::abs(patch.depthOf(placeOf(point))) > 2 * noise;
      }
    }
    EXPECT_LE(static_cast<double>(spikes), largest_share * static_cast<double>(points))
        << "density " << density;
  }
}

TEST(LonelyPoints, haveNoNormal)
{
  NoisyCloud cloud;
  cloud.viewpoints = {{0.3F, -0.2F, 5.0F}};
  Random random(5);
  cloud.addPatch(squarePatch(1, 0), 5000, 0.005, random, 0);
  const std::size_t plane = cloud.points.size();
  for (const Eigen::Vector3f& place : {Eigen::Vector3f(9, 9, 9),
                                       Eigen::Vector3f(-7, 3, 1),
                                       Eigen::Vector3f(-7, 3, 1.04F)})
    cloud.points.push_back(place);
  cloud.view.resize(cloud.points.size(), 0);
  const Consolidated found = consolidate(cloud, 0.1);
  std::size_t without = 0;
  for (const MapPoint& point : found.cloud) {
    EXPECT_TRUE(point.getVector3fMap().allFinite());
    const bool lonely = point.getVector3fMap().norm() > 5;
    EXPECT_EQ(std::isnan(point.normal_x), lonely);
    EXPECT_EQ(std::isnan(point.normal_z), lonely);
    without += lonely;
  }
  EXPECT_GE(without, 2U);
  EXPECT_EQ(found.report.without_normal, without);
  EXPECT_FALSE(found.cloud.is_dense);
  const auto& of = found.voxel_of_point;
  ASSERT_EQ(of.size(), plane + 3);
  EXPECT_NEAR(found.cloud[static_cast<std::size_t>(of[plane])].x, 9, 1e-4);
  EXPECT_EQ(of[plane + 1], of[plane + 2]) << "two points in one voxel";
  EXPECT_NEAR(found.cloud[static_cast<std::size_t>(of[plane + 1])].z, 1.02, 1e-4);
}

} // namespace
} // namespace pcl::acmap::test
