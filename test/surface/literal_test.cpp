#include "dewall_runs.h"
#include "figure_six.h"

#include <pcl/surface/impl/dewall_kernel.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::acmap::test {
namespace {

constexpr DeWallRule strict = DeWallRule::Strict;

/** Small clouds of every kind, with several seeds each. The limit of each edge is the same
 * everywhere. */
std::vector<DeWallCase>
makeLiteralCases()
{
  std::vector<DeWallCase> cases;
  const auto add = [&](const std::string& name, const Cloud& cloud, double length) {
    cases.push_back({name, cloud, length});
  };
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::string tail = "_" + std::to_string(seed);
    const auto sampling = [&](double noise) {
      return SheetSampling{11, 12, 1, 0.25, noise, seed};
    };
    const Cloud sheet = makeJitteredPlane(sampling(0.3)).cloud;
    Eigen::Isometry3d aside = Eigen::Isometry3d::Identity();
    aside.translation() << 14, 1, 2;
    add("plane" + tail, makeJitteredPlane(sampling(0)).cloud, 2.5);
    add("noisy_plane" + tail, sheet, 2.5);
    add("slab" + tail, makeJitteredPlane(sampling(2)).cloud, 3);
    add("short_edges" + tail, sheet, 1.3);
    add("sphere" + tail, makeSphereCap(sampling(0.1), 12).cloud, 2.5);
    add("edge" + tail, makeFoldedPlane(sampling(0.1), M_PI / 2).cloud, 2.5);
    add("two_clusters" + tail, Cloud(sheet) + moved(sheet, aside), 2.5);
    add("box" + tail, makeRandomBox(120, seed), 0.4);
    add("crumbs" + tail, makeRandomBox(60, seed), 0.2);
    add("corridor" + tail, makeCorridorView(150, seed), 0.8);
    add("few" + tail, makeRandomBox(3 + seed, seed), 0.9);
  }
  for (std::uint64_t order = 0; order < 3; ++order) {
    const std::string tail = "_" + std::to_string(order);
    const auto mixed = [&](const Cloud& cloud) { return permuted(cloud, order); };
    add("grid" + tail, mixed(makeGrid(9, 8, 1, ExactPlane::Level)), 2);
    add("inclined_grid" + tail, mixed(makeGrid(8, 7, 1, ExactPlane::Inclined)), 3);
    add("lattice" + tail, mixed(makeLattice(4)), 1.5);
    add("circle" + tail, mixed(makeExactCircle(5, false)), 20);
    add("circle_with_center" + tail, mixed(makeExactCircle(5, true)), 20);
  }
  return cases;
}

const std::vector<DeWallCase>&
literalCases()
{
  static const std::vector<DeWallCase> cases = makeLiteralCases();
  return cases;
}

class DeWallLiteral : public testing::TestWithParam<std::size_t> {
protected:
  const DeWallCase& case_ = literalCases()[GetParam()];
};

/** The triangles are also found in the same order, unless there are several clusters. */
TEST_P(DeWallLiteral, isFigureSix)
{
  std::optional<FigureSix> naive;
  for (const std::int32_t leaf_size : {1, 2, 20, 100000}) {
    SCOPED_TRACE("leaf size " + std::to_string(leaf_size));
    const DeWallResult result =
        triangulateInLeaves(case_.cloud, {strict, case_.length}, leaf_size);
    if (!naive)
      naive.emplace(result.points, case_.length);
    Triangles wanted = naive->mesh(leaf_size), found = result.mesh.triangles;
    for (Triangle& corners : found)
      std::sort(corners.begin(), corners.end());
    if (result.report.clusters > 1)
      for (Triangles* triangles : {&wanted, &found})
        std::sort(triangles->begin(), triangles->end());
    EXPECT_EQ(found, wanted);
    EXPECT_EQ(result.report.walls, naive->walls());
  }
}

TEST_P(DeWallLiteral, reportCountsTheMesh)
{
  const DeWallResult result = triangulate(case_.cloud, {strict, case_.length});
  const MeshCounts counts = countMesh(result.points, result.mesh.triangles);
  MeshDemands demands;
  demands.edge_allowed = noLongerThan(result.points, case_.length);
  demands.empty_spheres = result.report.clusters == 1; // P is the cluster
  const MeshFaults faults = checkMesh(result.points, result.mesh.triangles, demands);
  EXPECT_EQ(faults.forbidden_edges + faults.occupied_spheres + faults.duplicate_faces +
                faults.degenerate_faces + faults.invalid_faces,
            0U)
      << faults;
  EXPECT_EQ(result.report.crowded_edges, faults.crowded_edges);
  EXPECT_EQ(result.report.triangles, counts.faces);
  EXPECT_EQ(result.report.edges, counts.edges);
  EXPECT_EQ(result.report.boundary_edges, counts.boundary_edges);
  EXPECT_EQ(result.report.components, counts.components);
  EXPECT_EQ(result.report.used_points, counts.used_points);
}

TEST_P(DeWallLiteral, sameBytesForEveryNumberOfThreads)
{
  DeWallRun run{strict, case_.length, 1, true};
  const TriangleMesh one = triangulate(case_.cloud, run).mesh;
  for (const unsigned threads : {2U, 8U}) {
    run.threads = threads;
    const TriangleMesh many = triangulate(case_.cloud, run).mesh;
    EXPECT_EQ(many.triangles, one.triangles);
    EXPECT_EQ(many.wall_depth, one.wall_depth);
  }
}

INSTANTIATE_TEST_SUITE_P(Small,
                         DeWallLiteral,
                         testing::Range<std::size_t>(0, literalCases().size()),
                         [](const auto& info) {
                           return literalCases()[info.param].name;
                         });

/** Positions that are repeated, not finite or far away change nothing, nor does the unit. */
TEST(DeWallLiteralUgly, pointsOfNoUseChangeNothing)
{
  const Cloud sheet = makeJitteredPlane({12, 12, 1, 0.25, 0.2, 5}).cloud;
  const Triangles clean = triangulate(sheet, {strict, 2.5}).mesh.triangles;
  ASSERT_GT(clean.size(), 200U);
  EXPECT_EQ(triangulate(doubled(sheet), {strict, 2.5}).mesh.triangles, clean);
  const Cloud laced = lacedWithNan(sheet, 3);
  std::vector<std::int32_t> places;
  for (std::size_t i = 0; i < laced.size(); ++i)
    if (laced[i].getVector3fMap().allFinite())
      places.push_back(static_cast<std::int32_t>(i));
  EXPECT_EQ(asSets(triangulate(laced, {strict, 2.5}).mesh.triangles),
            asSets(clean, places));
  for (const float place : {1e9F, -1e9F, 3e38F})
    EXPECT_EQ(
        asSets(triangulate(withOutlier(sheet, place), {strict, 2.5}).mesh.triangles),
        asSets(clean));
  for (const float factor : {0x1p-60F, 0x1p-20F, 0x1p20F}) {
    const DeWallRun run{strict, 2.5 * static_cast<double>(factor)};
    EXPECT_EQ(triangulate(scaled(sheet, factor), run).mesh.triangles, clean) << factor;
  }
}

TEST(DeWallLiteralUgly, memoryLimitIsThatOfTheRule)
{
  const Cloud cloud = makeRandomBox(20000, 1);
  DeWallTriangulation<PointXYZ> dewall;
  dewall.setInputCloud(cloud.makeShared());
  dewall.setAcceptanceRule(strict);
  TriangleMesh mesh;
  dewall.setMemoryLimit(estimateDeWallMemory(cloud.size(), false, DeWallRule::Guarded));
  EXPECT_THROW(dewall.reconstruct(mesh), MemoryLimitException);
  dewall.setMemoryLimit(estimateDeWallMemory(cloud.size(), false, strict));
  EXPECT_NO_THROW(dewall.reconstruct(mesh));
}

/** Two sheets, of which one has the middle of both: the first plane of the whole cloud
 * would miss the other. */
TEST(DeWallLiteralClusters, eachHasItsOwnPlanes)
{
  const Cloud sheet = makeJitteredPlane({12, 12, 1, 0.25, 0.2, 5}).cloud;
  const DeWallResult alone = triangulate(sheet, {strict, 2.5, 1, true});
  EXPECT_EQ(alone.report.clusters, 1U);
  Eigen::Isometry3d aside = Eigen::Isometry3d::Identity();
  aside.translation().x() = 64;
  const DeWallResult both =
      triangulate(Cloud(sheet) + moved(sheet, aside), {strict, 2.5, 1, true});
  EXPECT_EQ(both.report.clusters, 2U);
  EXPECT_EQ(both.report.walls, 2 * alone.report.walls);
  EXPECT_EQ(both.mesh.triangles.size(), 2 * alone.mesh.triangles.size());
  auto depth = alone.mesh.wall_depth;
  depth.insert(depth.end(), alone.mesh.wall_depth.begin(), alone.mesh.wall_depth.end());
  EXPECT_EQ(both.mesh.wall_depth, depth);
}

/** P is the cluster: what lies in the sphere of a flat triangle, but out of reach of it, is of
 * another one. */
TEST(DeWallLiteralClusters, spheresAreEmptyOfTheirOwnPoints)
{
  Cloud cloud;
  for (const auto& [x, y] : {std::pair(0.0F, 0.0F),
                             {2.0F, 0.0F},
                             {1.0F, 0.3F},
                             {1.0F, -3.2F},
                             {1.2F, -3.1F},
                             {0.8F, -3.1F}})
    cloud.emplace_back(x, y, 0.0F);
  const DeWallResult found = triangulate(cloud, {strict, 2.1});
  EXPECT_EQ(found.report.clusters, 2U);
  EXPECT_EQ(asSets(found.mesh.triangles), Triangles({{0, 1, 2}, {3, 4, 5}}));
}

/** Fig. 5: a new splitting plane is orthogonal to the one before, although the halves of a long
 * sheet are still longer than wide. */
TEST(DeWallLiteralWalls, takeTurns)
{
  const Cloud cloud = makeJitteredPlane({32, 8, 1, 0.25, 0, 5}).cloud;
  const DeWallResult result = triangulate(cloud, {strict, 3, 1, true});
  const auto middleOf = [&](int axis, const auto& isIn) {
    std::vector<float> places;
    for (const auto& point : result.points)
      if (isIn(point))
        places.push_back(static_cast<float>(point[axis]));
    std::sort(places.begin(), places.end());
    return places[places.size() / 2];
  };
  const double first = middleOf(0, [](const auto&) { return true; });
  std::size_t across = 0, along = 0; // planes of the second calls
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
    const auto& corners = result.mesh.triangles[t];
    if (result.mesh.wall_depth[t] != 1)
      continue;
    const bool is_left = result.points[corners[0]].x() < first;
    const auto isInHalf = [&](const auto& point) {
      return (point.x() < first) == is_left;
    };
    const auto isCut = [&](int axis) {
      const double plane = middleOf(axis, isInHalf);
      const auto count = std::count_if(corners.begin(), corners.end(), [&](int i) {
        return result.points[i][axis] < plane;
      });
      return count > 0 && count < 3;
    };
    across += isCut(1);
    along += isCut(0);
  }
  EXPECT_GT(across, 20U);
  EXPECT_LT(5 * along, across) << "of the second planes";
}

/** The wall of the first call consists of the triangles that the first plane cuts. */
TEST(DeWallLiteralWalls, crossTheFirstPlane)
{
  const Cloud cloud = makeJitteredPlane({16, 12, 1, 0.25, 0, 5}).cloud;
  const DeWallResult result = triangulate(cloud, {strict, 3, 1, true});
  std::vector<double> along;
  for (const auto& point : result.points)
    along.push_back(point.x());
  std::sort(along.begin(), along.end());
  const double plane = along[along.size() / 2];
  std::size_t first = 0;
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
    const auto [low, high] = std::minmax_element(
        result.mesh.triangles[t].begin(),
        result.mesh.triangles[t].end(),
        [&](int i, int j) { return result.points[i].x() < result.points[j].x(); });
    const bool is_cut =
        result.points[*low].x() < plane && plane <= result.points[*high].x();
    EXPECT_EQ(result.mesh.wall_depth[t] == 0, is_cut) << "triangle " << t;
    first += is_cut;
  }
  EXPECT_GT(first, 20U);
  EXPECT_GT(result.report.walls, 3U);
}

TEST(DeWallLiteralWalls, areCountedForEveryRule)
{
  const Cloud cloud = makeJitteredPlane({16, 12, 1, 0.25, 0.1, 5}).cloud;
  for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense}) {
    EXPECT_EQ(triangulate(cloud, {rule, 3}).report.walls, 0U) << "not divided";
    EXPECT_EQ(triangulateInLeaves(cloud, {rule, 3}, 100).report.walls, 1U);
    EXPECT_EQ(triangulateInLeaves(cloud, {rule, 3}, 50).report.walls, 3U);
    EXPECT_EQ(triangulateInLeaves(cloud, {rule, 3}, 50).report.crowded_edges, 0U);
  }
  EXPECT_EQ(triangulateInLeaves(cloud, {strict, 3}, 1000).report.walls, 0U);
  Cloud large = makeGrid(256, 256, 1, ExactPlane::Level);
  EXPECT_EQ(triangulate(large, {DeWallRule::Guarded, 2}).report.walls, 0U);
  large.emplace_back(-1.0F, 0.0F, large[0].z);
  EXPECT_EQ(triangulate(large, {DeWallRule::Guarded, 2}).report.walls, 1U);
}

/** p1 is on the plane; its nearest point on the other side is not the nearest to the
 * plane, and the third one is behind p2. */
TEST(DeWallLiteralWalls, startWithTheNearestPoints)
{
  Cloud cloud;
  for (const auto& [x, y] : {std::pair(-3.0F, 0.0F),
                             {-2.0F, 0.9F},
                             {-1.0F, -2.5F},
                             {0.1F, 0.0F},
                             {1.2F, 0.6F},
                             {2.3F, -0.5F},
                             {3.1F, 0.4F}})
    cloud.emplace_back(x, y, 0.0F);
  const TriangleMesh mesh = triangulate(cloud, {strict, 5}).mesh;
  ASSERT_FALSE(mesh.triangles.empty());
  EXPECT_EQ(asSets({mesh.triangles[0]}), Triangles({{0, 1, 3}}));
}

TEST(DeWallLiteralFaces, lookTowardsTheSensor)
{
  Cloud cap = makeSphereCap({30, 30, 0.02, 0.25, 0, 1}, 0.5).cloud;
  for (const float height : {0.0F, 3.0F}) {
    cap.sensor_origin_ = Eigen::Vector4f(0, 0, height, 1);
    const DeWallResult result = triangulate(cap, {strict, 0.06});
    ASSERT_GT(result.mesh.triangles.size(), 1000U);
    for (const Triangle& t : result.mesh.triangles) {
      const auto& p = result.points;
      const Eigen::Vector3d center = (p[t[0]] + p[t[1]] + p[t[2]]) / 3;
      EXPECT_GT((p[t[1]] - p[t[0]])
                    .cross(p[t[2]] - p[t[0]])
                    .dot(Eigen::Vector3d(0, 0, height) - center),
                0);
    }
  }
}

} // namespace
} // namespace pcl::acmap::test
