#include "clouds.h"
#include "coverage.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

/** Two triangles for each square of the sample grid of a sheet. */
Triangles
gridTriangles(int columns, int rows)
{
  Triangles mesh;
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + 1 < columns; ++column) {
      const int a = row * columns + column;
      mesh.push_back({a, a + 1, a + columns});
      mesh.push_back({a + 1, a + columns + 1, a + columns});
    }
  return mesh;
}

TEST(Coverage, wholeMeshCoversTheInteriorOnce)
{
  for (const double fold : {0.0, M_PI / 2, -M_PI / 2}) {
    const SheetCloud sheet = makeFoldedPlane({20, 30, 0.5, 0.2, 0.1, 4}, fold);
    const Coverage coverage = measureCoverage(sheet, gridTriangles(20, 30));
    EXPECT_EQ(coverage.uncovered, 0);
    EXPECT_EQ(coverage.overlapped, 0);
  }
}

TEST(Coverage, regularMeshHasNoSeams)
{
  const SheetCloud sheet = makeJitteredPlane({20, 20, 1, 0, 0, 1});
  const Coverage coverage = measureCoverage(sheet, gridTriangles(20, 20));
  EXPECT_EQ(coverage.uncovered, 0);
  EXPECT_EQ(coverage.overlapped, 0);
}

TEST(Coverage, seesHolesAndDoubledFaces)
{
  const SheetCloud sheet = makeJitteredPlane({21, 21, 1, 0, 0, 1});
  Triangles mesh = gridTriangles(21, 21);
  const double half_square = 100 * 0.5 / (16 * 16);
  mesh.push_back(mesh[420]);
  EXPECT_NEAR(measureCoverage(sheet, mesh).overlapped, half_square, 0.1 * half_square);
  mesh.pop_back();
  mesh.erase(mesh.begin() + 420);
  EXPECT_NEAR(measureCoverage(sheet, mesh).uncovered, half_square, 0.1 * half_square);
  EXPECT_EQ(measureCoverage(sheet, {}).uncovered, 100);
}

TEST(Clouds, sameSeedSamePointsOtherSeedOthers)
{
  const auto plane = [](std::uint64_t seed) {
    return toPoints(makeJitteredPlane({10, 10, 1, 0.25, 0.1, seed}).cloud);
  };
  EXPECT_EQ(plane(3), plane(3));
  EXPECT_NE(plane(3), plane(4));
}

TEST(Clouds, foldedPlaneLiesOnItsTwoHalves)
{
  const SheetCloud sheet = makeFoldedPlane({21, 11, 1, 0.25, 0, 2}, M_PI / 2);
  for (std::size_t i = 0; i < sheet.cloud.size(); ++i) {
    const PointXYZ& p = sheet.cloud[i];
    EXPECT_NEAR(sheet.parameters[i].x() > 0 ? p.x : p.z, 0, 1e-6);
    EXPECT_NEAR(std::abs(sheet.parameters[i].x()), std::hypot(p.x, p.z), 1e-5);
  }
}

TEST(Clouds, motionKeepsDistancesAndPermutationKeepsPoints)
{
  const Cloud cloud = makeRandomBox(50, 1);
  const Cloud turned = moved(cloud, makeRandomMotion(5, 3));
  const Cloud mixed = permuted(cloud, 9);
  const auto distance = [](const PointXYZ& a, const PointXYZ& b) {
    return (a.getVector3fMap() - b.getVector3fMap()).norm();
  };
  EXPECT_GT(distance(cloud[0], turned[0]), 0.01F);
  for (std::size_t i = 1; i < cloud.size(); ++i)
    EXPECT_NEAR(distance(cloud[0], cloud[i]), distance(turned[0], turned[i]), 1e-5);
  std::size_t in_place = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    in_place += distance(cloud[i], mixed[i]) == 0;
    EXPECT_TRUE(std::any_of(mixed.begin(), mixed.end(), [&](const PointXYZ& p) {
      return distance(p, cloud[i]) == 0;
    }));
  }
  EXPECT_LT(in_place, 10U);
}

TEST(Clouds, corridorViewHasItsSizeAndStaysInTheCorridor)
{
  const Cloud view = makeCorridorView(5000, 1);
  EXPECT_EQ(view.size(), 5000U);
  for (const PointXYZ& p : view) {
    EXPECT_LT(std::abs(p.x), 1.35F);
    EXPECT_GT(p.y, -1.75F);
    EXPECT_LT(p.y, 1.25F);
    EXPECT_LT(p.z, 12.2F);
  }
}

TEST(Clouds, circleIsExact)
{
  EXPECT_EQ(makeExactCircle(5, false).size(), 12U);
  EXPECT_EQ(makeExactCircle(5, true).size(), 13U);
  EXPECT_EQ(makeExactCircle(25, false).size(), 20U);
  EXPECT_EQ(makeExactCircle(65, false).size(), 36U);
}

TEST(Clouds, gradedPlaneGrowsItsSpacing)
{
  const SheetCloud sheet = makeGradedPlane({40, 60, 0.01, 0.2, 0, 1}, 10);
  const ReferenceTree tree(toPoints(sheet.cloud));
  const auto spacing = [&](const PointXYZ& p) {
    return std::sqrt(tree.nearest(p.getVector3fMap().cast<double>(), 2).back().first);
  };
  EXPECT_LT(spacing(sheet.cloud.front()), 0.015);
  EXPECT_GT(spacing(sheet.cloud.back()), 0.05);
}

} // namespace
} // namespace pcl::acmap::test
