#include "consolidation_runs.h"

#include <gtest/gtest.h>

#include <map>

namespace pcl::acmap::test {
namespace {

/** The end of a corridor in one view: the side walls are oblique, so that the noise
 * along the rays is mostly parallel to them; the end wall is frontal, with the full
 * noise. */
TEST(FacedWall, isOnePlaneInSpiteOfItsNoise)
{
  NoisyCloud cloud;
  cloud.viewpoints = {{0, 0, 0}};
  Random random(61);
  const Patch end{{-1.2, 1.2, 5}, {2.4, 0, 0}, {0, -2.4, 0}};
  cloud.addPatch({{-1.2, -1.2, 1}, {0, 2.4, 0}, {0, 0, 4}}, 9000, 0.009, random);
  cloud.addPatch({{1.2, -1.2, 1}, {0, 0, 4}, {0, 2.4, 0}}, 9000, 0.009, random);
  cloud.addPatch(end, 9000, 0.028, random);
  for (const double voxel : {0.05, 0.08}) {
    const SheetFit fit = fitOf(consolidate(cloud, voxel).cloud, end, voxel, 0.5, 0.25);
    EXPECT_NEAR(fit.mean, 0, 0.003) << voxel;
    EXPECT_LT(fit.rms, 0.006) << voxel;
    EXPECT_LT(fit.median_angle, 0.03) << voxel;
    EXPECT_GT(fit.coverage, 0.7) << voxel;
  }
}

TEST(Rim, isReached)
{
  NoisyCloud cloud;
  cloud.viewpoints = {{0.5F, 0.7F, 4}};
  Random random(62);
  const Patch patch{{0.013, 0.021, 0.03}, {2, 0, 0}, {0, 2, 0}};
  cloud.addPatch(patch, 20000, 0.005, random);
  constexpr double voxel = 0.08;
  std::map<int, double> farthest; // maximum x of each row
  for (const MapPoint& point : consolidate(cloud, voxel).cloud) {
    double& x = farthest[static_cast<int>(point.y / voxel)];
    x = std::max(x, static_cast<double>(point.x));
  }
  double short_of = 0;
  for (const auto& row : farthest)
    short_of +=
        (patch.corner.x() + 2 - row.second) / static_cast<double>(farthest.size());
  EXPECT_LT(short_of, 0.4 * voxel);
  EXPECT_GT(short_of, -0.1 * voxel);
}

} // namespace
} // namespace pcl::acmap::test
