#include <pcl/core/impl/moments.h>
#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <vector>

namespace pcl::acmap::test {
namespace {

using Places = std::vector<Eigen::Vector3d>;

Places
makePlaces(std::size_t size, std::uint64_t seed)
{
  Random random(seed);
  Places places;
  for (std::size_t i = 0; i < size; ++i) {
    const double x = random.uniform(-1, 2);
    const double y = random.uniform(0, 5);
    places.emplace_back(x, y, 0.3 * x + random.normal());
  }
  return places;
}

Moments
momentsOf(const Places& places, const Eigen::Vector3d& origin = Eigen::Vector3d::Zero())
{
  Moments sum;
  for (const Eigen::Vector3d& place : places) {
    const Eigen::Vector3d p = place - origin;
    ++sum.count;
    sum.x += p.x();
    sum.y += p.y();
    sum.z += p.z();
    sum.xx += p.x() * p.x();
    sum.xy += p.x() * p.y();
    sum.xz += p.x() * p.z();
    sum.yy += p.y() * p.y();
    sum.yz += p.y() * p.z();
    sum.zz += p.z() * p.z();
  }
  return sum;
}

void
expectNear(const Moments& found, const Moments& wanted)
{
  constexpr double tolerance = 1e-9;
  EXPECT_EQ(found.count, wanted.count);
  EXPECT_NEAR(found.x, wanted.x, tolerance);
  EXPECT_NEAR(found.y, wanted.y, tolerance);
  EXPECT_NEAR(found.z, wanted.z, tolerance);
  EXPECT_NEAR(found.xx, wanted.xx, tolerance);
  EXPECT_NEAR(found.xy, wanted.xy, tolerance);
  EXPECT_NEAR(found.xz, wanted.xz, tolerance);
  EXPECT_NEAR(found.yy, wanted.yy, tolerance);
  EXPECT_NEAR(found.yz, wanted.yz, tolerance);
  EXPECT_NEAR(found.zz, wanted.zz, tolerance);
}

TEST(Moments, addUp)
{
  const Places first = makePlaces(40, 1);
  const Places second = makePlaces(25, 2);
  Places both = first;
  both.insert(both.end(), second.begin(), second.end());
  Moments sum = momentsOf(first);
  sum += momentsOf(second);
  expectNear(sum, momentsOf(both));
  EXPECT_TRUE(sum.mean().isApprox(momentsOf(both).mean()));
}

TEST(Moments, ofAnotherOriginAreShifted)
{
  const Places first = makePlaces(30, 3);
  const Places second = makePlaces(20, 4);
  const Eigen::Vector3d origin(0.7, -1.3, 2.1);
  Places both = first;
  both.insert(both.end(), second.begin(), second.end());
  Moments sum = momentsOf(first);
  sum.addShifted(momentsOf(second, origin), origin.x(), origin.y(), origin.z());
  expectNear(sum, momentsOf(both));
}

TEST(Moments, areScaledToAnotherUnit)
{
  Places millimetres = makePlaces(30, 5);
  const Moments metres = momentsOf(millimetres);
  for (Eigen::Vector3d& place : millimetres)
    place *= 4;
  expectNear(metres.scaled(4), momentsOf(millimetres));
}

TEST(FitPlane, variancesAreThoseOfTheCovariance)
{
  const Places places = makePlaces(200, 6);
  const PlaneFit fit = fitPlane(momentsOf(places));
  EXPECT_EQ(fit.count, 200);
  EXPECT_NEAR(fit.normal.norm(), 1, 1e-12);
  double across = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& place : places)
    mean += place / 200;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& place : places) {
    across += std::pow((place - mean).dot(fit.normal), 2) / 200;
    covariance += (place - mean) * (place - mean).transpose() / 200;
  }
  EXPECT_TRUE(fit.mean.isApprox(mean, 1e-12));
  EXPECT_NEAR(fit.variances[0], across, 1e-9);
  EXPECT_NEAR(fit.variances.sum(), covariance.trace(), 1e-9);
  EXPECT_NEAR(fit.variances.prod(), covariance.determinant(), 1e-8);
  // no direction has a smaller variance
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d direction =
        Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    EXPECT_GE(direction.dot(covariance * direction), across - 1e-9);
  }
}

TEST(FitPlane, exactPointsGiveTheirPlane)
{
  Random random(8);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d normal =
        Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    const Eigen::Vector3d u = normal.unitOrthogonal();
    const Eigen::Vector3d v = normal.cross(u);
    Places places;
    for (int k = 0; k < 9; ++k)
      places.emplace_back(Eigen::Vector3d(0.2, -0.1, 0.3) + (k % 3 - 1.0) * u +
                          (k / 3 - 1.0) * 0.8 * v);
    const PlaneFit fit = fitPlane(momentsOf(places));
    EXPECT_NEAR(std::abs(fit.normal.dot(normal)), 1, 1e-10);
    EXPECT_NEAR(
        fit.mean.dot(normal), Eigen::Vector3d(0.2, -0.1, 0.3).dot(normal), 1e-12);
    EXPECT_LT(fit.variances[0], 1e-12);
    EXPECT_TRUE(fit.isPlanar());
  }
}

TEST(FitPlane, linesAndBallsAreNotPlanar)
{
  Places line, ball;
  Random random(9);
  for (int k = 0; k < 500; ++k) {
    line.emplace_back(0.1 * k + 0.01 * random.normal(),
                      0.01 * random.normal(),
                      0.01 * random.normal());
    ball.emplace_back(random.normal(), random.normal(), random.normal());
  }
  EXPECT_FALSE(fitPlane(momentsOf(line)).isPlanar());
  EXPECT_FALSE(fitPlane(momentsOf(ball)).isPlanar());
  EXPECT_FALSE(fitPlane(momentsOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})).isPlanar())
      << "three points lie in one plane always";
}

TEST(FitPlane, onePointIsItsOwnMean)
{
  const PlaneFit fit = fitPlane(momentsOf({{0.25, 0.5, -0.25}}));
  EXPECT_EQ(fit.mean, Eigen::Vector3d(0.25, 0.5, -0.25));
  EXPECT_TRUE(fit.variances.isZero(1e-15));
  EXPECT_TRUE(fit.normal.allFinite());
}

} // namespace
} // namespace pcl::acmap::test
