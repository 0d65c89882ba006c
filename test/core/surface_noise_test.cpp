#include <pcl/core/impl/surface_noise.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace pcl::acmap::test {
namespace {

using Points = std::vector<Eigen::Vector3f>;

PointView
viewOf(const Points& points)
{
  return PointView(points.data(), sizeof(Eigen::Vector3f), points.size());
}

/** Floor, ceiling and two walls of a room of 6 x 5 x 2.6 m, without order. */
Points
makeRoom(std::size_t count, float noise, std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> share(0, 1);
  std::normal_distribution<float> error(0, noise);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const float a = share(random), b = share(random), e = error(random);
    const float kind = share(random);
    if (kind < 0.35F)
      points.emplace_back(6 * a, 5 * b, e);
    else if (kind < 0.7F)
      points.emplace_back(6 * a, 5 * b, 2.6F + e);
    else if (kind < 0.85F)
      points.emplace_back(6 * a, e, 2.6F * b);
    else
      points.emplace_back(e, 5 * a, 2.6F * b);
  }
  return points;
}

TEST(SurfaceNoise, isThatOfTheSurfaceAtAnyDensity)
{
  for (const std::size_t count : {6000U, 30000U, 120000U})
    for (const float sigma : {0.003F, 0.005F, 0.015F}) {
      const SurfaceNoise noise = measureSurfaceNoise(viewOf(makeRoom(count, sigma, 1)));
      SCOPED_TRACE(std::to_string(count) + " points, " + std::to_string(sigma) + " m");
      ASSERT_TRUE(noise.is_determined) << noise.reason;
      EXPECT_NEAR(
          noise.sigma, static_cast<double>(sigma), 0.2 * static_cast<double>(sigma));
      EXPECT_LE(noise.low, noise.sigma);
      EXPECT_GE(noise.high, noise.sigma);
      EXPECT_LT(noise.high - noise.low, 0.25 * noise.sigma);
      EXPECT_NEAR(noise.spacing,
                  std::sqrt(88.6 / static_cast<double>(count)),
                  0.25 * noise.spacing);
    }
}

TEST(SurfaceNoise, neverTakesAStoreyForAPlane)
{
  const SurfaceNoise noise = measureSurfaceNoise(viewOf(makeRoom(400, 0.003F, 2)));
  EXPECT_LT(noise.sigma, 0.05) << "of floor and ceiling, 2.6 m apart";
}

TEST(SurfaceNoise, isNotDeterminedInAThicket)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<float> share(0, 4);
  Points points;
  for (int i = 0; i < 20000; ++i)
    points.emplace_back(share(random), share(random), share(random));
  const SurfaceNoise noise = measureSurfaceNoise(viewOf(points));
  EXPECT_FALSE(noise.is_determined);
  EXPECT_EQ(noise.sigma, 0);
  EXPECT_FALSE(noise.reason.empty());
}

TEST(SurfaceNoise, dependsNeitherOnOrderNorOnThreadsNorOnWhatIsNoPoint)
{
  Points points = makeRoom(20000, 0.004F, 4);
  const SurfaceNoise noise = measureSurfaceNoise(viewOf(points), 1);
  const Points twice = points;
  points.insert(points.end(), twice.begin(), twice.end());
  points.resize(points.size() + 20000, Eigen::Vector3f::Zero());
  points.resize(points.size() + 9, Eigen::Vector3f::Constant(std::nanf("")));
  std::shuffle(points.begin(), points.end(), std::mt19937(5));
  const SurfaceNoise same = measureSurfaceNoise(viewOf(points), 2);
  EXPECT_EQ(noise.sigma, same.sigma);
  EXPECT_EQ(noise.high, same.high);
  EXPECT_EQ(noise.spacing, same.spacing);
}

TEST(SurfaceNoise, ofFewPointsOrNoneIsNotDetermined)
{
  for (const std::size_t count : {0U, 1U, 3U, 79U}) {
    const SurfaceNoise noise = measureSurfaceNoise(viewOf(makeRoom(count, 0.004F, 6)));
    EXPECT_FALSE(noise.is_determined) << count;
    EXPECT_FALSE(noise.reason.empty()) << count;
  }
  const Points coincident(5000, Eigen::Vector3f(1, 2, 3));
  EXPECT_FALSE(measureSurfaceNoise(viewOf(coincident)).is_determined);
}

TEST(SurfaceNoise, ofAScanWithoutNoiseIsZero)
{
  const SurfaceNoise noise = measureSurfaceNoise(viewOf(makeRoom(30000, 0, 7)));
  EXPECT_EQ(noise.sigma, 0);
}

} // namespace
} // namespace pcl::acmap::test
