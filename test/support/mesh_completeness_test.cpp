#include "clouds.h"
#include "mesh_completeness.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

constexpr double degree = M_PI / 180;

/** A grid of five columns and four rows of points, slightly distorted, and all its
 * triangles. */
struct MeshPatch {
  Points points;
  Triangles mesh;
  CompletenessRule rule;

  MeshPatch()
  {
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 5; ++column)
        points.emplace_back(column + 0.1 * row, row, 0);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) {
        const int a = 5 * row + column;
        mesh.push_back({a, a + 1, a + 5});
        mesh.push_back({a + 1, a + 6, a + 5});
      }
    rule.edge_allowed = noLongerThan(points, 1.5);
    rule.turn_limit = 60 * degree;
  }
};

TEST(MeshCompleteness, acceptsACompleteMesh)
{
  const MeshPatch patch;
  MeshDemands demands;
  demands.empty_spheres = true;
  EXPECT_EQ(checkMesh(patch.points, patch.mesh, demands).total(), 0U);
  EXPECT_TRUE(missingUnderPaperRule(patch.points, patch.mesh, patch.rule).empty());
  EXPECT_TRUE(missingUnderDenseRule(patch.points, patch.mesh, patch.rule).empty());
}

TEST(MeshCompleteness, findsEachTriangleThatIsTakenAway)
{
  const MeshPatch patch;
  for (std::size_t face = 0; face < patch.mesh.size(); ++face) {
    Triangles mesh = patch.mesh;
    mesh.erase(mesh.begin() + static_cast<std::ptrdiff_t>(face));
    EXPECT_EQ(missingUnderPaperRule(patch.points, mesh, patch.rule).size(), 1U);
    EXPECT_FALSE(missingUnderDenseRule(patch.points, mesh, patch.rule).empty());
  }
}

TEST(MeshCompleteness, findsASeedAmongUnusedPoints)
{
  const MeshPatch patch;
  EXPECT_EQ(missingUnderPaperRule(patch.points, {}, patch.rule).size(),
            patch.mesh.size());
  EXPECT_EQ(missingUnderDenseRule(patch.points, {}, patch.rule).size(),
            patch.mesh.size());
}

TEST(MeshCompleteness, sizeConstraintExcusesGaps)
{
  MeshPatch patch;
  patch.rule.edge_allowed = noLongerThan(patch.points, 0.9);
  EXPECT_TRUE(missingUnderPaperRule(patch.points, {}, patch.rule).empty());
}

TEST(MeshCompleteness, turnLimitExcusesSharpFolds)
{
  const Points hinge{{0, 0, 0}, {0, 1, 0}, {-1, 0.5, 0}, {0.3, 0.5, 0.9}};
  const Triangles mesh{{0, 1, 2}};
  CompletenessRule rule;
  rule.edge_allowed = noLongerThan(hinge, 1.2);
  rule.turn_limit = 75 * degree;
  EXPECT_EQ(missingUnderPaperRule(hinge, mesh, rule).size(), 1U);
  EXPECT_EQ(missingUnderDenseRule(hinge, mesh, rule).size(), 1U);
  rule.turn_limit = 60 * degree;
  EXPECT_TRUE(missingUnderPaperRule(hinge, mesh, rule).empty());
  EXPECT_TRUE(missingUnderDenseRule(hinge, mesh, rule).empty());
}

TEST(MeshCompleteness, secondFanExcusesAGap)
{
  const Points bow{{0, 0, 0}, {-1, 0.5, 0}, {-1, -0.5, 0}, {1, 0.5, 0}, {1, -0.5, 0}};
  CompletenessRule rule;
  rule.edge_allowed = noLongerThan(bow, 1.5);
  rule.turn_limit = 60 * degree;
  EXPECT_TRUE(missingUnderPaperRule(bow, {{0, 1, 2}}, rule).empty());
  EXPECT_EQ(missingUnderPaperRule(bow, {}, rule).size(), 2U);
}

/** A closed strip of triangles without its last triangle, and this triangle. In a
 * Moebius strip no orientation of the last triangle is consistent with both
 * neighbours. */
struct Ring {
  static constexpr int around = 9;
  Points points;
  Triangles mesh;
  Triangle last;

  explicit Ring(double half_turns)
  {
    for (int i = 0; i < around; ++i)
      for (const double side : {-0.3, 0.3}) {
        const double angle = 2 * M_PI * i / around;
        const double distance = 1 + side * std::cos(half_turns * angle / 2);
        points.emplace_back(distance * std::cos(angle),
                            distance * std::sin(angle),
                            side * std::sin(half_turns * angle / 2));
      }
    const int size = 2 * around;
    const int first = half_turns > 0 ? 1 : 0;
    for (int i = 0; i + 2 < size; ++i)
      mesh.push_back(i % 2 == 0 ? Triangle{i, i + 1, i + 2}
                                : Triangle{i + 1, i, i + 2});
    mesh.push_back({size - 2, size - 1, first});
    last = {first, size - 1, 1 - first};
    std::sort(last.begin(), last.end());
  }

  bool
  misses(const Triangle& triangle) const
  {
    CompletenessRule rule;
    rule.edge_allowed = [](std::int32_t, std::int32_t) { return true; };
    rule.turn_limit = M_PI;
    rule.sphere_slack = 1;
    const Triangles missing = missingUnderPaperRule(points, mesh, rule);
    return std::find(missing.begin(), missing.end(), triangle) != missing.end();
  }
};

TEST(MeshCompleteness, moebiusBandIsExcusedFromItsLastTriangle)
{
  const Ring plain(0);
  ASSERT_EQ(checkMesh(plain.points, plain.mesh).inconsistent_edges, 0U);
  EXPECT_TRUE(plain.misses(plain.last));
  const Ring twisted(1);
  ASSERT_EQ(checkMesh(twisted.points, twisted.mesh).inconsistent_edges, 0U);
  EXPECT_FALSE(twisted.misses(twisted.last));
}

TEST(MeshCompleteness, turnAngleGrowsFromFlatToFoldedBack)
{
  const Eigen::Vector3d a(0, 0, 0);
  const Eigen::Vector3d b(0, 1, 0);
  const Eigen::Vector3d p(-1, 0.2, 0);
  for (const double angle : {0.0, 10.0, 90.0, 170.0, 180.0}) {
    const Eigen::Vector3d q(
        2 * std::cos(angle * degree), 0.7, 2 * std::sin(angle * degree));
    EXPECT_NEAR(turnAngle(a, b, p, q), angle * degree, 1e-9);
  }
}

TEST(MeshCompleteness, describesATriangleByItsCorners)
{
  EXPECT_EQ(describe({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, {2, 0, 1}),
            "triangle 2 (7 8 9) 0 (1 2 3) 1 (4 5 6)");
}

} // namespace
} // namespace pcl::acmap::test
