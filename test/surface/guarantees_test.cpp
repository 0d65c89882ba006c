#include "dewall_runs.h"

#include <map>
#include <utility>

namespace pcl::acmap::test {
namespace {

/** All synthetic clouds with both guarded rules. */
class DeWallGuarantees
: public testing::TestWithParam<std::tuple<std::size_t, DeWallRule>> {
protected:
  const DeWallCase& case_ = syntheticCases()[std::get<0>(GetParam())];
  DeWallRun run_{std::get<1>(GetParam()), case_.length};
};

TEST_P(DeWallGuarantees, holdOnEveryCloud)
{
  const DeWallResult result = triangulate(case_.cloud, run_);
  EXPECT_TRUE(keepsGuarantees(result, run_));
  EXPECT_GT(result.mesh.triangles.size(), 0U);
}

/** The largest turn from a triangle to its neighbour is 127 degrees. */
TEST_P(DeWallGuarantees, noTriangleIsFoldedBack)
{
  const DeWallResult result = triangulate(case_.cloud, run_);
  std::map<std::pair<int, int>, int> third; // of the first triangle at a side
  for (const Triangle& t : result.mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      const auto [side, is_first] = third.emplace(std::minmax(a, b), c);
      if (is_first)
        continue;
      const Eigen::Vector3d along = (result.points[b] - result.points[a]).normalized();
      const auto across = [&](int corner) {
        const Eigen::Vector3d way = result.points[corner] - result.points[a];
        return Eigen::Vector3d(way - way.dot(along) * along).normalized();
      };
      EXPECT_LT(across(c).dot(across(side->second)), 0.6 + 1e-6);
    }
}

TEST_P(DeWallGuarantees, holdWhenDividedIntoSmallLeaves)
{
  for (const std::int32_t leaf_size : {8, 50, 300}) {
    const DeWallResult result = triangulateInLeaves(case_.cloud, run_, leaf_size);
    EXPECT_TRUE(keepsGuarantees(result, run_)) << "leaf size " << leaf_size;
    EXPECT_GT(result.mesh.triangles.size(), 0U);
  }
}

TEST_P(DeWallGuarantees, holdForAnyOrderOfThePoints)
{
  const std::size_t triangles = triangulate(case_.cloud, run_).mesh.triangles.size();
  for (const std::uint64_t seed : {1U, 2U}) {
    const DeWallResult mixed = triangulate(permuted(case_.cloud, seed), run_);
    EXPECT_TRUE(keepsGuarantees(mixed, run_));
    EXPECT_NEAR(static_cast<double>(mixed.mesh.triangles.size()),
                static_cast<double>(triangles),
                0.05 * static_cast<double>(triangles) + 2);
  }
}

TEST_P(DeWallGuarantees, sameBytesForEveryNumberOfThreads)
{
  run_.depth = true;
  for (const std::int32_t leaf_size : {20, 200, 100000}) {
    run_.threads = 1;
    const TriangleMesh one = triangulateInLeaves(case_.cloud, run_, leaf_size).mesh;
    for (const unsigned threads : {1U, 2U, 8U}) {
      run_.threads = threads;
      const TriangleMesh many = triangulateInLeaves(case_.cloud, run_, leaf_size).mesh;
      EXPECT_EQ(one.triangles, many.triangles) << threads << " threads";
      EXPECT_EQ(one.wall_depth, many.wall_depth) << threads << " threads";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Synthetic,
    DeWallGuarantees,
    testing::Combine(testing::Range<std::size_t>(0, syntheticCases().size()),
                     testing::Values(DeWallRule::Guarded, DeWallRule::Dense)),
    [](const auto& info) {
      return syntheticCases()[std::get<0>(info.param)].name + "_" +
             nameOf(std::get<1>(info.param));
    });

} // namespace
} // namespace pcl::acmap::test
