#include "clouds.h"
#include "facade.h"
#include "noisy_clouds.h"

#include <pcl/core/noise_scale.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace pcl::acmap::test {
namespace {

NoiseScale
measure(const Cloud& cloud)
{
  return measureNoiseScale({cloud.data(), sizeof(PointXYZ), cloud.size()}, {});
}

NoiseScale
measure(const NoisyCloud& cloud, unsigned threads = 0)
{
  return measureNoiseScale(cloud.pointView(), cloud.sensorView(), threads);
}

void
expectNoNoise(const NoiseScale& scale, const std::string& what)
{
  EXPECT_FALSE(scale.hasNoise()) << what << ": " << scale.sigma;
  EXPECT_FALSE(scale.remarks.empty()) << what;
  EXPECT_TRUE(scale.ranges.empty()) << what;
}

TEST(NoiseScale, ofPlanesIsTold)
{
  std::uint64_t seed = 0;
  for (const double inclination : {0.0, 0.35, 0.9})
    for (const double sigma : {0.003, 0.01, 0.03})
      for (const double density : {3000.0, 30000.0}) {
        NoisyCloud cloud;
        Random random(++seed);
        cloud.addPatch(squarePatch(2.5, inclination), density, sigma, random, -1);
        const NoiseScale scale = measure(cloud);
        const double spacing = 1 / std::sqrt(density);
        const auto what = testing::Message() << "sigma " << sigma << ", density "
                                             << density << ", at " << inclination;
        EXPECT_NEAR(scale.sigma, sigma, 0.15 * sigma) << what;
        EXPECT_NEAR(scale.spacing, spacing, 0.15 * spacing) << what;
        EXPECT_GT(scale.sparse_spacing, 0.85 * spacing) << what;
        EXPECT_LT(scale.sparse_spacing, 1.5 * spacing) << what;
        EXPECT_GT(scale.confidence, 0.5) << what;
        EXPECT_TRUE(scale.remarks.empty()) << what;
      }
}

TEST(NoiseScale, ofARoomIsToldInSpiteOfItsEdges)
{
  for (const double sigma : {0.005, 0.02}) {
    const NoiseScale scale = measure(makeNoisyRoom(700, sigma, 7));
    EXPECT_NEAR(scale.sigma, sigma, 0.15 * sigma);
    EXPECT_NEAR(scale.spacing, 1 / std::sqrt(700), 0.15 / std::sqrt(700));
    EXPECT_GT(scale.confidence, 0.5);
    EXPECT_TRUE(scale.remarks.empty());
  }
}

TEST(NoiseScale, scalesWithTheUnit)
{
  NoisyCloud metres;
  Random random(3);
  metres.addPatch(squarePatch(2, 0.4), 10000, 0.01, random, -1);
  NoisyCloud millimetres = metres;
  for (Eigen::Vector3f& point : millimetres.points)
    point *= 1000;
  const NoiseScale small = measure(metres);
  const NoiseScale large = measure(millimetres);
  EXPECT_NEAR(large.sigma, 1000 * small.sigma, 30 * small.sigma);
  EXPECT_NEAR(large.spacing, 1000 * small.spacing, 30 * small.spacing);
}

/** Uniformly distributed points on a ball of 0.5 m: curved, but without noise. */
Cloud
makeBall(std::size_t size)
{
  Random random(5);
  Cloud cloud;
  for (std::size_t i = 0; i < size; ++i) {
    const Eigen::Vector3d direction =
        Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    PointXYZ point;
    point.getVector3fMap() = (0.5 * direction).cast<float>();
    cloud.push_back(point);
  }
  return cloud;
}

/** A turned part as exported by a CAD program: rings of vertices with flat ends. */
Cloud
makeTurnedPart()
{
  Cloud cloud;
  const auto ring = [&](double radius, double height, int vertices) {
    for (int k = 0; k < vertices; ++k) {
      const double angle = 2 * M_PI * k / vertices;
      cloud.push_back({static_cast<float>(radius * std::cos(angle)),
                       static_cast<float>(radius * std::sin(angle)),
                       static_cast<float>(height)});
    }
  };
  for (int row = 0; row <= 60; ++row)
    ring(0.2, 0.01 * row, 126);
  for (int circle = 1; circle < 20; ++circle)
    for (const double end : {0.0, 0.6})
      ring(0.01 * circle, end, 6 * circle);
  return cloud;
}

/** The faces of a cube as grids, which share its edges. */
Cloud
makeCube(int steps)
{
  Cloud cloud;
  const auto at = [&](int k) {
    return static_cast<float>(k) / static_cast<float>(steps);
  };
  for (int x = 0; x <= steps; ++x)
    for (int y = 0; y <= steps; ++y)
      for (int z = 0; z <= steps; ++z)
        if (x % steps == 0 || y % steps == 0 || z % steps == 0)
          cloud.push_back({at(x), at(y), at(z)});
  return cloud;
}

TEST(NoiseScale, shapeIsNotNoise)
{
  expectNoNoise(measure(makeBall(5000)), "ball");
  expectNoNoise(measure(makeBall(100000)), "ball of many points");
  expectNoNoise(measure(makeTurnedPart()), "turned part");
  expectNoNoise(measure(makeCube(40)), "cube");
  expectNoNoise(measure(makeGrid(60, 60, 0.0625, ExactPlane::Level)), "level grid");
  expectNoNoise(measure(makeGrid(60, 60, 0.0625, ExactPlane::Inclined)), "slope");
  expectNoNoise(measure(makeRandomPlane(5000, ExactPlane::Inclined, 1)), "random");
}

/** Corridors of 60 m side by side, with doors that stand out of their walls.
 * \param[in] every metres from door to door */
NoisyCloud
makeCorridors(double every)
{
  constexpr double density = 100, length = 60, width = 2.4, height = 2.5;
  Random random(11);
  NoisyCloud cloud;
  const auto add = [&](double x, double y, double z, double u, double v, int across) {
    Patch patch{{x, y, z}, {0, 0, u}, {0, 0, 0}};
    patch.v[across] = v;
    cloud.addPatch(patch, density, 0, random, -1);
  };
  for (int corridor = 0; corridor < 8; ++corridor) {
    const double left = 15 * corridor, right = left + width;
    add(left, 0, 0, length, width, 0);
    add(left, height, 0, length, width, 0);
    add(left, 0, 0, length, height, 1);
    add(right, 0, 0, length, height, 1);
    for (double z = 1; z + 1 < length; z += every) {
      add(left + 0.1, 0, z, 0.9, 2.1, 1);
      add(right - 0.1, 0, z, 0.9, 2.1, 1);
    }
  }
  return cloud;
}

TEST(NoiseScale, aStoreyIsNoThickPlane)
{
  expectNoNoise(measure(makeCorridors(10)), "corridors");
  // doors close to each other are told from noise with a doubt, but the storey is not noise
  EXPECT_LT(measure(makeCorridors(2)).sigma, 0.02);
}

TEST(NoiseScale, windowsOfAFacadeAreNoNoise)
{
  int told = 0;
  constexpr int facades = 12;
  for (int seed = 1; seed <= facades; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const double sigma = random.uniform(0.002, 0.008);
    const std::vector<Eigen::Vector3f> facade = makeFacade(sigma, random);
    const NoiseScale scale =
        measureNoiseScale({facade.data(), sizeof(Eigen::Vector3f), facade.size()}, {});
    EXPECT_LT(scale.sigma, 3 * sigma) << seed;
    told += std::abs(scale.sigma - sigma) <= 0.2 * sigma;
  }
  EXPECT_EQ(told, facades);
}

TEST(NoiseScale, noiseThatIsGreaterElsewhereIsNoStep)
{
  // two halves of a wall, one of them of dark stone
  for (const double share : {0.3, 0.4}) {
    NoisyCloud cloud;
    Random random(5);
    cloud.addPatch({{0, 0, 0}, {8 * share, 0, 0}, {0, 0, 5}}, 2000, 0.002, random, -1);
    cloud.addPatch({{8 * share, 0, 0}, {8 * (1 - share), 0, 0}, {0, 0, 5}},
                   2000,
                   0.012,
                   random,
                   -1);
    EXPECT_GT(measure(cloud).sigma, 0.008) << share;
  }
}

TEST(NoiseScale, spacingIsToldWithoutNoise)
{
  const NoiseScale scale = measure(makeGrid(80, 80, 0.0625, ExactPlane::Level));
  EXPECT_NEAR(scale.spacing, 0.0625, 0.15 * 0.0625);
  EXPECT_NEAR(measure(makeCube(40)).spacing, 1 / 40.0, 0.15 / 40);
}

TEST(NoiseScale, ofHardlyAnythingIsARemark)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  Cloud invalid;
  invalid.resize(100, PointXYZ(nan, nan, nan));
  for (const auto& [what, cloud] : std::vector<std::pair<std::string, Cloud>>{
           {"no point", {}},
           {"one point", makeRandomBox(1, 1)},
           {"two points", makeRandomBox(2, 1)},
           {"three points", makeRandomBox(3, 1)},
           {"one place", makeCoincident(5000)},
           {"a line", makeCollinear(5000)},
           {"not finite", invalid},
           {"far apart", withOutlier(makeRandomBox(1, 1), 1e9F)}}) {
    const NoiseScale scale = measure(cloud);
    expectNoNoise(scale, what);
    EXPECT_TRUE(std::isfinite(scale.spacing)) << what;
    EXPECT_GE(scale.confidence, 0) << what;
    EXPECT_LE(scale.confidence, 1) << what;
  }
}

TEST(NoiseScale, invalidAndDistantPointsDoNotCount)
{
  NoisyCloud cloud;
  Random random(9);
  cloud.addPatch(squarePatch(2, 0.4), 10000, 0.01, random, -1);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < cloud.points.size(); i += 5)
    cloud.points[i].y() = nan;
  cloud.points[1] = {1e9F, 1e9F, 1e9F};
  cloud.points[2] = {-1e9F, 0, 1e9F};
  const NoiseScale scale = measure(cloud);
  EXPECT_NEAR(scale.sigma, 0.01, 0.0015);
  EXPECT_NEAR(scale.spacing, 1 / std::sqrt(8000), 0.15 / std::sqrt(8000));
}

TEST(NoiseScale, ofSolidStuffIsDoubtful)
{
  const NoiseScale scale = measure(makeRandomBox(20000, 3));
  EXPECT_TRUE(!scale.hasNoise() || scale.confidence < 0.5) << scale.confidence;
}

TEST(NoiseScale, neitherThreadsNorViewsChangeIt)
{
  const NoisyCloud cloud = makeNoisyRoom(2000, 0.01, 11); // 864 000 points
  const NoiseScale alone = measure(cloud, 1);
  ASSERT_TRUE(alone.hasNoise());
  for (const unsigned threads : {2U, 8U}) {
    const NoiseScale scale = measure(cloud, threads);
    EXPECT_EQ(scale.sigma, alone.sigma);
    EXPECT_EQ(scale.spacing, alone.spacing);
    EXPECT_EQ(scale.sparse_spacing, alone.sparse_spacing);
    EXPECT_EQ(scale.confidence, alone.confidence);
    ASSERT_EQ(scale.ranges.size(), alone.ranges.size());
    for (std::size_t k = 0; k < scale.ranges.size(); ++k) {
      EXPECT_EQ(scale.ranges[k].sigma, alone.ranges[k].sigma);
      EXPECT_EQ(scale.ranges[k].points, alone.ranges[k].points);
    }
  }
  EXPECT_TRUE(measureNoiseScale(cloud.pointView(), {}).ranges.empty());
}

/** A wall that recedes to one side, with noise along the ray of 0.3 % of the distance.
 * Observed from (1, 2, 3). */
NoisyCloud
makeRecedingWall(std::uint64_t seed)
{
  const Eigen::Vector3d sensor(1, 2, 3);
  NoisyCloud cloud;
  cloud.viewpoints = {sensor.cast<float>()};
  Random random(seed);
  for (int i = 0; i < 200000; ++i) {
    const Eigen::Vector3d ray =
        Eigen::Vector3d(random.uniform(-0.7, 0.7), random.uniform(-0.4, 0.4), 1);
    const double depth = 3 / (1 - 0.9 * ray.x()); // intersection with the plane z = 3 +
                                                  // 0.9 x
    const Eigen::Vector3d hit = ray * depth;
    const double noise = 0.003 * hit.norm() * random.normal();
    cloud.points.emplace_back((sensor + hit + noise * ray.normalized()).cast<float>());
    cloud.view.push_back(0);
  }
  return cloud;
}

TEST(NoiseScale, growsWithTheDistanceAsTold)
{
  const NoiseScale scale = measure(makeRecedingWall(13));
  ASSERT_GE(scale.ranges.size(), 4U);
  double last = 0;
  std::size_t points = 0;
  for (const NoiseScale::Range& range : scale.ranges) {
    EXPECT_GT(range.distance, last);
    last = range.distance;
    points += range.points;
    if (range.points < 1000) // the last bins are incomplete
      continue;
    EXPECT_NEAR(range.sigma, 0.003 * range.distance, 0.15 * 0.003 * range.distance)
        << "at " << range.distance;
  }
  EXPECT_GT(points, 12000U);
  EXPECT_GT(scale.ranges.back().sigma, 2 * scale.ranges.front().sigma);
}

/** Standard deviation of the points about their true planes: the median over squares of
 * 10 cm. */
double
trueSigma(const std::vector<Eigen::Vector3f>& points,
          const std::vector<std::uint32_t>& labels,
          const std::vector<TruthPlane>& planes)
{
  std::map<std::array<long, 4>, std::pair<double, double>> squares;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (labels[i] == 0)
      continue;
    const Eigen::Vector4d& plane = planes[labels[i] - 1].coefficients;
    const Eigen::Vector3d point = points[i].cast<double>();
    const double off = plane.head<3>().dot(point) + plane[3];
    const Eigen::Vector3d foot = 10 * (point - off * plane.head<3>());
    auto& [sum, count] = squares[{labels[i],
                                  std::lround(foot.x()),
                                  std::lround(foot.y()),
                                  std::lround(foot.z())}];
    sum += off * off;
    ++count;
  }
  std::vector<double> sigmas;
  for (const auto& [place, square] : squares)
    if (square.second >= 5)
      sigmas.push_back(std::sqrt(square.first / square.second));
  const auto middle = sigmas.begin() + static_cast<std::ptrdiff_t>(sigmas.size() / 2);
  std::nth_element(sigmas.begin(), middle, sigmas.end());
  return *middle;
}

TEST(NoiseScale, ofTheCorridorIsTold)
{
  for (const std::size_t views : {1, 4}) {
    SimulatedScene scene = standardScene("corridor");
    scene.sensor.points = 100000 / views;
    scene.sensor.views_with_one_more = 0;
    const MergedObservations merged = mergeObservations(scene, views, 3);
    NoisyCloud cloud;
    cloud.points = merged.points;
    cloud.view = merged.view;
    for (const Eigen::Isometry3d& pose : merged.trajectory.poses)
      cloud.viewpoints.emplace_back(pose.translation().cast<float>());
    const NoiseScale scale = measure(cloud);
    const double sigma = trueSigma(merged.points, merged.label, merged.planes);
    EXPECT_NEAR(scale.sigma, sigma, 0.15 * sigma) << views << " views";
    ASSERT_FALSE(scale.ranges.empty());
    for (const NoiseScale::Range& range : scale.ranges) {
      const double wanted = range.distance < 1.9 ? 0.01 : range.sigma; // below 2 m
      EXPECT_NEAR(range.sigma, wanted, 0.15 * wanted) << views << " views";
    }
  }
}

} // namespace
} // namespace pcl::acmap::test
