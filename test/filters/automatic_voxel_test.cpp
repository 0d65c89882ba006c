#include "clouds.h"
#include "consolidation_runs.h"

#include <pcl/core/noise_scale.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

struct Slab {
  double sigma;
  double density;
};

class AutomaticVoxel : public testing::TestWithParam<Slab> {};

TEST_P(AutomaticVoxel, leavesLittleNoise)
{
  const auto [sigma, density] = GetParam();
  NoisyCloud cloud;
  cloud.viewpoints = {{0.3F, -0.2F, 5.0F}};
  Random random(81);
  const Patch patch = squarePatch(2, 0.2);
  cloud.addPatch(patch, density, sigma, random, 0);
  const Consolidated found = consolidate(cloud, 0);
  const double voxel = found.report.voxel_size;
  EXPECT_GT(voxel, 1.9 / std::sqrt(density)) << "holds a few points";
  EXPECT_GT(found.report.residual, 0);
  EXPECT_LE(found.report.residual, voxel / 60);
  const SheetFit fit = fitOf(found.cloud, patch, voxel, 0.5, 2.5 * voxel);
  EXPECT_LT(fit.rms, voxel / 40);
  EXPECT_LT(fit.median_angle, 0.03);
  EXPECT_GT(fit.coverage, 0.6);
  // setting this voxel size explicitly gives the same result
  const Consolidated named = consolidate(cloud, voxel);
  ASSERT_EQ(named.cloud.size(), found.cloud.size());
  for (std::size_t i = 0; i < found.cloud.size(); ++i)
    ASSERT_EQ(named.cloud[i].getVector3fMap(), found.cloud[i].getVector3fMap());
}

INSTANTIATE_TEST_SUITE_P(Consolidation,
                         AutomaticVoxel,
                         testing::Values(Slab{0.003, 3000},
                                         Slab{0.01, 3000},
                                         Slab{0.01, 30000},
                                         Slab{0.03, 30000}));

TEST(AutomaticVoxel, ofAnExactGridFollowsItsSpacing)
{
  VoxelConsolidation<PointXYZ> consolidation;
  consolidation.setInputCloud(makeGrid(80, 80, 0.0625, ExactPlane::Level).makeShared());
  Cloud output;
  consolidation.filter(output);
  EXPECT_EQ(consolidation.getVoxelSize(), 0) << "parameters stay as set";
  EXPECT_GT(consolidation.getReport().voxel_size, 1.8 * 0.0625);
  EXPECT_LT(consolidation.getReport().voxel_size, 3 * 0.0625);
  EXPECT_GT(output.size(), 500U);
}

TEST(AutomaticVoxel, cannotBeToldFromHardlyAnything)
{
  for (const Cloud& cloud : {makeRandomBox(1, 1),
                             makeRandomBox(2, 1),
                             makeCoincident(1000),
                             makeCollinear(1000)}) {
    VoxelConsolidation<PointXYZ> consolidation;
    consolidation.setInputCloud(cloud.makeShared());
    Cloud output;
    output.resize(3);
    consolidation.filter(output);
    EXPECT_TRUE(output.empty());
    const auto& remarks = consolidation.getReport().remarks;
    EXPECT_TRUE(
        std::any_of(remarks.begin(), remarks.end(), [](const std::string& remark) {
          return remark.find("no voxel size can be told") != std::string::npos;
        }));
    EXPECT_EQ(consolidation.getReport().voxel_size, 0);
  }
}

} // namespace
} // namespace pcl::acmap::test
