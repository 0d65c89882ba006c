#include "clouds.h"
#include "dewall/dewall_kernel.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

#ifdef ACMAP_SIMD_AVX2

void
expectSameMeshes(const Cloud& cloud, DeWallRule rule, const std::string& what)
{
  DeWallSettings settings;
  settings.rule = rule;
  settings.compute_wall_depth = true;
  settings.leaf_size = 256;
  DeWallInput input;
  input.points = PointView(cloud.front().data, sizeof(PointXYZ), cloud.size());
  DeWallReport of_base, of_avx2;
  const TriangleMesh base = dewall::triangulate(input, settings, Progress(), of_base);
  const TriangleMesh avx2 =
      dewall_avx2::triangulate(input, settings, Progress(), of_avx2);
  EXPECT_EQ(base.triangles, avx2.triangles) << what;
  EXPECT_EQ(base.wall_depth, avx2.wall_depth) << what;
  EXPECT_EQ(of_base.clusters, of_avx2.clusters) << what;
  EXPECT_EQ(of_base.median_spacing, of_avx2.median_spacing) << what;
}

class DeWallVariants : public testing::TestWithParam<DeWallRule> {
protected:
  void
  SetUp() override
  {
    if (!__builtin_cpu_supports("avx2"))
      GTEST_SKIP() << "the processor has no AVX2";
  }
};

/** With and without noise, with large coordinates, and with many exact ties. */
TEST_P(DeWallVariants, giveTheSameMeshes)
{
  const std::vector<std::pair<std::string, Cloud>> clouds{
      {"plane", makeJitteredPlane({40, 40, 1, 0.25, 0.3, 1}).cloud},
      {"box", makeRandomBox(700, 2)},
      {"grid", makeGrid(30, 30, 0.25, ExactPlane::Level)},
      {"far",
       moved(makeRandomBox(300, 3),
             Eigen::Isometry3d(Eigen::Translation3d(3000, -5000, 800)))},
      {"view", makeCorridorView(3000, 5)}};
  for (const auto& [name, cloud] : clouds)
    expectSameMeshes(cloud, GetParam(), name);
}

/** Leaves that do not fill a vector; squares that are denormal or nearly too large. */
TEST_P(DeWallVariants, giveTheSameMeshesOfAnySizeAndScale)
{
  for (const float scale : {1.0F, 1e-22F, 1e-38F, 1e18F, 1e25F})
    for (std::size_t points = 3; points <= 40; ++points)
      expectSameMeshes(scaled(makeRandomBox(points, points), scale),
                       GetParam(),
                       std::to_string(points) + " points, scale " +
                           std::to_string(scale));
}

INSTANTIATE_TEST_SUITE_P(Rules,
                         DeWallVariants,
                         testing::Values(DeWallRule::Guarded,
                                         DeWallRule::Dense,
                                         DeWallRule::Strict));

#endif

} // namespace
} // namespace pcl::acmap::test
