#include "entropy_runs.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

void
expectSame(const MapEntropyTerms& terms, const MapEntropyTerms& wanted, double rounding)
{
  EXPECT_NEAR(terms.total, wanted.total, rounding);
  EXPECT_NEAR(terms.joint, wanted.joint, rounding);
  EXPECT_NEAR(terms.along_x, wanted.along_x, rounding);
  EXPECT_NEAR(terms.along_z, wanted.along_z, rounding);
  EXPECT_EQ(terms.points, wanted.points);
}

TEST(ExactEntropy, countsBits)
{
  MapEntropy<PointNormal> entropy;
  entropy.setBinSize(1);
  entropy.setSmoothing(0);
  entropy.addPointCloud(cloudAt({{0.1, 0.1}, {0.9, 1.9}, {1.5, 0.5}, {1.2, 1.2}}));
  entropy.addPointCloud(cloudAt({{0.2, 0.2}, {0.2, 1.2}, {1.2, 0.2}, {1.2, 1.9}}));
  const MapEntropyTerms even = entropy.computeExact();
  EXPECT_NEAR(even.joint, 2, 1e-12);
  EXPECT_NEAR(even.along_x, 1, 1e-12);
  EXPECT_NEAR(even.along_z, 1, 1e-12);
  EXPECT_NEAR(even.total, 3, 1e-12) << "mu is 0.5";
  EXPECT_EQ(even.points, 8U);
  EXPECT_EQ(even.dimensions, 2);
  entropy.clear();
  entropy.addPointCloud(cloudAt({{-0.1, 0.1}, {-0.9, 0.9}, {-0.5, 0.2}}));
  EXPECT_NEAR(entropy.computeExact().total, 0, 1e-12) << "all in one bin";
}

TEST(ExactEntropy, isTheNaiveOne)
{
  const PosedClouds map = makeRoomViews(3, 700, 5);
  for (const bool directions : {false, true})
    for (const double sigma : {0.0, 0.05, 0.1, 0.23}) {
      NaiveEntropySettings settings;
      settings.sigma = sigma;
      settings.mu = 0.7;
      settings.directions = directions;
      SCOPED_TRACE(testing::Message()
                   << "directions " << directions << " sigma " << sigma);
      if (sigma == 0)
        settings.sigma = 1e-9; // for the naive loop, which divides by it
      const MapEntropyTerms wanted = naiveEntropy(map, settings);
      settings.sigma = sigma;
      expectSame(entropyOf(map, settings).computeExact(), wanted, 1e-6);
    }
}

/** Keeps at most one point per cloud in each cell of a bin. */
PosedClouds
oneACell(PosedClouds map, double bin)
{
  for (auto& cloud : map.clouds) {
    std::vector<std::pair<long, long>> taken;
    PointCloud<PointNormal>::Ptr kept(new PointCloud<PointNormal>);
    for (const PointNormal& point : *cloud) {
      const std::pair<long, long> cell(
          std::lround(std::floor(static_cast<double>(point.x) / bin)),
          std::lround(std::floor(static_cast<double>(point.z) / bin)));
      if (std::find(taken.begin(), taken.end(), cell) != taken.end())
        continue;
      taken.push_back(cell);
      kept->push_back(point);
    }
    cloud = kept;
  }
  return map;
}

TEST(FastEntropy, isTheNaiveSplineWhereEachCellHasOnePoint)
{
  for (const bool directions : {false, true}) {
    NaiveEntropySettings settings;
    settings.directions = directions;
    settings.splines = true;
    const PosedClouds map = oneACell(makeRoomViews(3, 400, 6), settings.bin);
    ASSERT_GT(map.clouds[0]->size(), 100U);
    expectSame(entropyOf(map, settings).compute(), naiveEntropy(map, settings), 1e-5);
  }
}

TEST(FastEntropy, isNearTheNaiveSplineWithCellsOfManyPoints)
{
  for (const bool directions : {false, true}) {
    NaiveEntropySettings settings;
    settings.directions = directions;
    settings.splines = true;
    const PosedClouds map = makeRoomViews(4, 5000, 7);
    auto entropy = entropyOf(map, settings);
    EXPECT_NEAR(entropy.compute().total, naiveEntropy(map, settings).total, 0.02);
    EXPECT_LT(entropy.getReport().cells, 10000U) << "half of the points";
  }
}

/** The error bound documented by the class. */
double
boundOf(const NaiveEntropySettings& settings)
{
  return (2 + 2 * settings.mu) * std::log2(7.0) +
         (settings.directions ? std::log2(5.0) : 0);
}

TEST(FastEntropy, staysWithinItsBoundOfTheExactOne)
{
  double maximum = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    for (const bool directions : {false, true})
      for (const double sigma : {0.0, 0.1}) {
        NaiveEntropySettings settings;
        settings.sigma = sigma;
        settings.directions = directions;
        auto entropy = entropyOf(makeRoomViews(3, 2000, seed), settings);
        const double difference =
            std::abs(entropy.compute().total - entropy.computeExact().total);
        EXPECT_LE(difference, boundOf(settings));
        if (sigma > 0 && !directions)
          maximum = std::max(maximum, difference);
      }
  EXPECT_LT(maximum, 0.1) << "in practice";
  RecordProperty("most_bits", std::to_string(maximum));
}

TEST(FastEntropy, staysWithinItsBoundForOnePoint)
{
  for (const double x : {0.0, 0.05, 0.0999, 0.3}) {
    NaiveEntropySettings settings;
    settings.sigma = 0;
    MapEntropy<PointNormal> entropy =
        entropyOf({{cloudAt({{x, x}})}, {{0, 0, 0}}}, settings);
    const double difference =
        std::abs(entropy.compute().total - entropy.computeExact().total);
    EXPECT_GT(difference, 1) << "the spline shares it among bins, all by itself";
    EXPECT_LE(difference, boundOf(settings));
  }
}

} // namespace
} // namespace pcl::acmap::test
