#include "polygon_checks.h"

#include "outlines/face_loops.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace pcl::acmap::test {
namespace {

using Triangles = TriangleMesh::Triangles;

/** A grid of squares, of which those selected by a function are split into two
 * triangles. */
struct FlatMesh {
  std::vector<Eigen::Vector2d> places;
  Triangles triangles;

  template <typename IsThere>
  FlatMesh(int side, const IsThere& isThere)
  {
    for (int y = 0; y <= side; ++y)
      for (int x = 0; x <= side; ++x)
        places.emplace_back(x, y);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const std::int32_t a = y * (side + 1) + x, b = a + side + 1;
        if (isThere(x, y, 0))
          triangles.push_back({a, a + 1, b + 1});
        if (isThere(x, y, 1))
          triangles.push_back({a, b + 1, b});
      }
  }

  FlatLoop
  flat(const std::vector<std::int32_t>& loop) const
  {
    FlatLoop result;
    for (const std::int32_t vertex : loop)
      result.push_back(places[static_cast<std::size_t>(vertex)]);
    return result;
  }
};

TEST(FaceLoops, squareHasOne)
{
  const FlatMesh mesh(4, [](int, int, int) { return true; });
  const auto loops = outlines::faceLoops(mesh.triangles, mesh.places);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops[0].size(), 16U);
  EXPECT_DOUBLE_EQ(areaOf(mesh.flat(loops[0])), 16);
}

TEST(FaceLoops, holeRunsClockwise)
{
  const FlatMesh mesh(5, [](int x, int y, int) { return x != 2 || y != 2; });
  const auto loops = outlines::faceLoops(mesh.triangles, mesh.places);
  ASSERT_EQ(loops.size(), 2U);
  std::vector<double> areas{areaOf(mesh.flat(loops[0])), areaOf(mesh.flat(loops[1]))};
  std::sort(areas.begin(), areas.end());
  EXPECT_DOUBLE_EQ(areas[0], -1);
  EXPECT_DOUBLE_EQ(areas[1], 25);
}

/** Two squares that touch at a corner have separate loops, and so do two such holes. */
TEST(FaceLoops, rimsStayWithTheirSideWhereTheyTouch)
{
  const auto isBlack = [](int x, int y, int) { return (x + y) % 2 == 0; };
  const FlatMesh squares(2, isBlack);
  const auto two = outlines::faceLoops(squares.triangles, squares.places);
  ASSERT_EQ(two.size(), 2U);
  for (const auto& loop : two) {
    EXPECT_EQ(loop.size(), 4U);
    EXPECT_DOUBLE_EQ(areaOf(squares.flat(loop)), 1);
  }
  const FlatMesh holes(4, [&](int x, int y, int) {
    return x == 0 || y == 0 || x == 3 || y == 3 || isBlack(x, y, 0);
  });
  const auto loops = outlines::faceLoops(holes.triangles, holes.places);
  ASSERT_EQ(loops.size(), 2U);
  double area = 0;
  for (const auto& loop : loops)
    area += areaOf(holes.flat(loop));
  EXPECT_DOUBLE_EQ(area, 14)
      << "the holes hang together, as the surface between does not";
}

/** The common vertex of two squares is the first vertex of both loops. */
TEST(FaceLoops, rimsThatBeginWhereTheyTouchAreTwo)
{
  const std::vector<Eigen::Vector2d> places{
      {0, 0}, {1, 0}, {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}};
  const Triangles squares{{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 6}};
  const auto loops = outlines::faceLoops(squares, places);
  ASSERT_EQ(loops.size(), 2U);
  for (const auto& loop : loops) {
    ASSERT_EQ(loop.size(), 4U);
    FlatLoop flat;
    for (const std::int32_t vertex : loop)
      flat.push_back(places[static_cast<std::size_t>(vertex)]);
    EXPECT_DOUBLE_EQ(areaOf(flat), 1);
  }
}

TEST(FaceLoops, nothingHasNone)
{
  EXPECT_TRUE(outlines::faceLoops({}, {}).empty());
}

/** Every edge with one triangle is in one loop, with the surface on its left. */
TEST(FaceLoops, goRoundAnySurface)
{
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const double share = random.uniform(0.2, 0.95);
    const FlatMesh mesh(12, [&](int, int, int) { return random.uniform() < share; });
    std::set<std::pair<std::int32_t, std::int32_t>> rim;
    for (const TriangleMesh::Triangle& t : mesh.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        if (rim.erase({t[(k + 1) % 3], t[k]}) == 0)
          rim.insert({t[k], t[(k + 1) % 3]});
    double area = 0;
    std::size_t edges = 0;
    for (const auto& loop : outlines::faceLoops(mesh.triangles, mesh.places)) {
      area += areaOf(mesh.flat(loop));
      for (std::size_t i = 0; i < loop.size(); ++i, ++edges)
        EXPECT_EQ(rim.count({loop[i], loop[(i + 1) % loop.size()]}), 1U);
      EXPECT_EQ(countCrossings(mesh.flat(loop)), 0U);
    }
    EXPECT_EQ(edges, rim.size()) << "seed " << seed;
    EXPECT_NEAR(area, static_cast<double>(mesh.triangles.size()) / 2, 1e-9);
  }
}

/** If an invalid mesh has three triangles at an edge, the third one has no boundary
 * there. */
TEST(FaceLoops, doubledTrianglesEndWell)
{
  FlatMesh mesh(3, [](int, int, int) { return true; });
  mesh.triangles.push_back(mesh.triangles[4]);
  mesh.triangles.push_back({0, 0, 5});
  for (const auto& loop : outlines::faceLoops(mesh.triangles, mesh.places))
    EXPECT_GE(loop.size(), 3U);
}

} // namespace
} // namespace pcl::acmap::test
