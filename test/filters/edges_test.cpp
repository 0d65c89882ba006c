#include "consolidation_runs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

constexpr double sigma = 0.01;
constexpr double density = 15000; // points per square metre

/** A wall of 3 m by 2.7 m with a door panel of 0.9 m by 2.1 m recessed by 10 cm, and
 * the reveal around it, observed from three positions in front of it. */
struct Recess {
  Patch wall, panel;
  NoisyCloud cloud;
};

Patch
uprightPatch(double left, double right, double low, double high, double z)
{
  return {{left, low, z}, {right - left, 0, 0}, {0, high - low, 0}};
}

/** \param[in] turn rotation of the wall about the vertical y axis, radians */
Recess
makeRecess(double turn)
{
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.rotate(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitY()));
  motion.translation() = Eigen::Vector3d(0.013, 0.027, 0.031);
  Recess recess;
  for (const Eigen::Vector3d& station : {Eigen::Vector3d(0, 1.2, 3),
                                         Eigen::Vector3d(-1.2, 1.3, 2.5),
                                         Eigen::Vector3d(1.1, 1.1, 2.8)})
    recess.cloud.viewpoints.emplace_back((motion * station).cast<float>());
  Random random(41);
  const auto add = [&](const Patch& patch) {
    for (const int view : {0, 1, 2})
      recess.cloud.addPatch(patch.movedBy(motion), density / 3, sigma, random, view);
  };
  recess.wall = uprightPatch(-1.5, 1.5, 0, 2.7, 0).movedBy(motion);
  recess.panel = uprightPatch(-0.45, 0.45, 0, 2.1, -0.1).movedBy(motion);
  add(uprightPatch(-1.5, -0.45, 0, 2.7, 0));
  add(uprightPatch(0.45, 1.5, 0, 2.7, 0));
  add(uprightPatch(-0.45, 0.45, 2.1, 2.7, 0));
  add(uprightPatch(-0.45, 0.45, 0, 2.1, -0.1));
  add({{-0.45, 0, -0.1}, {0, 0, 0.1}, {0, 2.1, 0}});
  add({{0.45, 0, 0}, {0, 0, -0.1}, {0, 2.1, 0}});
  add({{-0.45, 2.1, 0}, {0, 0, -0.1}, {0.9, 0, 0}});
  return recess;
}

class DoorPanel : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(DoorPanel, keepsItsDepth)
{
  const auto [turn, voxel] = GetParam();
  const Recess recess = makeRecess(turn);
  const MapCloud cloud = consolidate(recess.cloud, voxel).cloud;
  const SheetFit panel = fitOf(cloud, recess.panel, voxel, 0.05, 0.1);
  EXPECT_NEAR(panel.mean, 0, 0.005);
  EXPECT_LT(panel.rms, 0.006);
  EXPECT_GT(panel.coverage, 0.75);

  // depths of the panel, and of the wall beside it, except near their border
  double panel_sum = 0, wall_sum = 0, panel_points = 0, wall_points = 0;
  for (const MapPoint& point : cloud) {
    const double inset = insetIn(recess.panel, placeOf(point));
    const double depth = recess.wall.depthOf(placeOf(point));
    if (inset > 0.1) {
      panel_sum += std::abs(depth + 0.1);
      ++panel_points;
    }
    else if (inset < -0.1 && insetIn(recess.wall, placeOf(point)) > 0.1) {
      wall_sum += std::abs(depth);
      ++wall_points;
    }
  }
  EXPECT_LT(panel_sum / panel_points, 0.005);
  EXPECT_LT(wall_sum / wall_points, 0.005);
  EXPECT_GT(panel_points * voxel * voxel, 0.75 * 0.7 * 1.9);
}

INSTANTIATE_TEST_SUITE_P(Consolidation,
                         DoorPanel,
                         testing::Combine(testing::Values(0.0, 0.5),
                                          testing::Values(0.04, 0.05, 0.06, 0.08)));

class Crease : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(Crease, staysOnItsPlanes)
{
  const auto [turn, voxel] = GetParam();
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.rotate(Eigen::AngleAxisd(turn, Eigen::Vector3d(0.3, 1, 0.2).normalized()));
  motion.translation() = Eigen::Vector3d(0.013, 0.027, 0.031);
  const std::array<Patch, 2> planes = {
      Patch{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}.movedBy(motion),
      Patch{{0, 0, 0}, {0, 2, 0}, {0, 0, 2}}.movedBy(motion)};
  NoisyCloud cloud;
  cloud.viewpoints = {(motion * Eigen::Vector3d(2, 1, 2)).cast<float>()};
  Random random(51);
  for (const Patch& plane : planes)
    cloud.addPatch(plane, density, sigma, random, 0);
  std::size_t near = 0, strayed = 0;
  for (const MapPoint& point : consolidate(cloud, voxel).cloud) {
    const double first = planes[0].depthOf(placeOf(point));
    const double second = planes[1].depthOf(placeOf(point));
    const double along = (motion.inverse() * placeOf(point)).y();
    if (std::hypot(first, second) > voxel || along < 2.5 * voxel ||
        along > 2 - 2.5 * voxel)
      continue;
    ++near;
    strayed += std::min(std::abs(first), std::abs(second)) > voxel / 2 + sigma;
  }
  EXPECT_GT(static_cast<double>(near), 1.2 / voxel);
  EXPECT_LE(static_cast<double>(strayed), 0.02 * static_cast<double>(near));
}

INSTANTIATE_TEST_SUITE_P(Consolidation,
                         Crease,
                         testing::Combine(testing::Values(0.0, 0.4, 0.785),
                                          testing::Values(0.04, 0.06, 0.1)));

} // namespace
} // namespace pcl::acmap::test
