#include "dewall_runs.h"

#include <algorithm>

namespace pcl::acmap::test {
namespace {

class DeWallEquivariance
: public testing::TestWithParam<std::tuple<std::size_t, DeWallRule>> {
protected:
  const DeWallCase& case_ = syntheticCases()[std::get<0>(GetParam())];
  DeWallRun run_{std::get<1>(GetParam()), case_.length};
};

TriangleMesh::Triangles
withoutSides(TriangleMesh::Triangles triangles)
{
  for (TriangleMesh::Triangle& triangle : triangles)
    std::sort(triangle.begin(), triangle.end());
  return triangles;
}

/** But the side of what may be an object: rooms are larger. */
TEST_P(DeWallEquivariance, scaleByPowersOfTwoChangesNothing)
{
  const DeWallResult original = triangulate(case_.cloud, run_);
  for (const float factor : {0.125F, 64.0F}) {
    DeWallRun run = run_;
    run.length = run_.length * static_cast<double>(factor);
    const DeWallResult other = triangulate(scaled(case_.cloud, factor), run);
    if (original.report.sides == other.report.sides)
      EXPECT_EQ(original.mesh.triangles, other.mesh.triangles) << "factor " << factor;
    else
      EXPECT_EQ(withoutSides(original.mesh.triangles),
                withoutSides(other.mesh.triangles))
          << "factor " << factor;
  }
}

TEST_P(DeWallEquivariance, rigidMotionKeepsNumberAndGuarantees)
{
  const double size =
      static_cast<double>(triangulate(case_.cloud, run_).mesh.triangles.size());
  const double reach = static_cast<double>(case_.cloud.front().getVector3fMap().norm());
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Eigen::Isometry3d motion = makeRandomMotion(seed, reach);
    const DeWallResult other = triangulate(moved(case_.cloud, motion), run_);
    EXPECT_TRUE(keepsGuarantees(other, run_));
    EXPECT_NEAR(
        static_cast<double>(other.mesh.triangles.size()), size, 0.08 * size + 2);
  }
}

/** Clouds whose coordinates can be moved or scaled without relevant rounding errors. */
std::vector<std::size_t>
movableCases()
{
  std::vector<std::size_t> movable;
  for (std::size_t i = 0; i < syntheticCases().size(); ++i) {
    const std::string& name = syntheticCases()[i].name;
    const bool brittle = name.rfind("outlier", 0) == 0 || name == "far_from_origin" ||
                         name == "laced_with_nan";
    if (!brittle && name.rfind("grid", 0) != 0)
      movable.push_back(i);
  }
  return movable;
}

INSTANTIATE_TEST_SUITE_P(Synthetic,
                         DeWallEquivariance,
                         testing::Combine(testing::ValuesIn(movableCases()),
                                          testing::Values(DeWallRule::Guarded,
                                                          DeWallRule::Dense)),
                         [](const auto& info) {
                           return syntheticCases()[std::get<0>(info.param)].name + "_" +
                                  nameOf(std::get<1>(info.param));
                         });

} // namespace
} // namespace pcl::acmap::test
