#include "dewall_runs.h"

#include <pcl/core/random.h>
#include <pcl/surface/impl/dewall_kernel.h>

namespace pcl::acmap::test {
namespace {

/** The image of two walls that meet at a corner, with noise along the rays about as
 * large as the spacing; every tenth pixel is missing. */
Cloud
makeCornerView(std::uint64_t seed)
{
  constexpr std::uint32_t width = 120, height = 90;
  Random random(seed);
  Cloud cloud(width, height, PointXYZ());
  for (std::uint32_t row = 0; row < height; ++row)
    for (std::uint32_t column = 0; column < width; ++column) {
      const double x = (column + 0.5 - width / 2.0) / width;
      const double y = (row + 0.5 - height / 2.0) / width;
      const double depth = 2.0 / (1.0 + 0.8 * std::abs(x)) + 0.012 * random.normal();
      cloud.at(column, row) = random.uniform() < 0.1
                                  ? PointXYZ(NAN, NAN, NAN)
                                  : PointXYZ(static_cast<float>(x * depth),
                                             static_cast<float>(y * depth),
                                             static_cast<float>(depth));
    }
  cloud.is_dense = false;
  return cloud;
}

bool
isSingleView(const Cloud& cloud, const Eigen::Vector3d& origin)
{
  return acmap::isSingleView(
      PointView(cloud.data(), sizeof(PointXYZ), cloud.size()), cloud.width, origin);
}

/** Fraction of the area that faces away from the origin. */
double
areaFacingAway(const DeWallResult& result)
{
  double away = 0, all = 0;
  for (const Triangle& t : result.mesh.triangles) {
    const Eigen::Vector3d a = result.points[t[0]];
    const double shown =
        (result.points[t[1]] - a).cross(result.points[t[2]] - a).dot(-a.normalized());
    away += std::max(0.0, -shown);
    all += std::abs(shown);
  }
  return away / all;
}

TEST(SingleView, isKnownByItsRays)
{
  const Cloud view = makeCornerView(1);
  EXPECT_TRUE(isSingleView(view, {0, 0, 0}));
  EXPECT_FALSE(isSingleView(view, {0, 0, 3})) << "from behind the walls";
  EXPECT_FALSE(isSingleView(view, {0.3, 0.2, 1.9})) << "from among the points";
}

TEST(SingleView, isNotKnownFromAFewPixels)
{
  Cloud view = makeCornerView(1);
  for (std::uint32_t i = 30; i < view.size(); ++i)
    view[i].z = NAN;
  EXPECT_FALSE(isSingleView(view, {0, 0, 0}));
  EXPECT_FALSE(isSingleView(Cloud(), {0, 0, 0}));
  EXPECT_FALSE(isSingleView(Cloud(5, 1), {0, 0, 0}));
}

TEST(SingleView, facesItsSensorInSpiteOfNoise)
{
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense}) {
      const DeWallRun run{rule, 0.08};
      const DeWallResult result = triangulate(makeCornerView(seed), run);
      EXPECT_TRUE(keepsGuarantees(result, run));
      EXPECT_GT(result.report.used_points, 9000U);
      EXPECT_LT(areaFacingAway(result), 0.05) << "seed " << seed;
    }
}

} // namespace
} // namespace pcl::acmap::test
