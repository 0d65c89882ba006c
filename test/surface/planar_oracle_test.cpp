#include "dewall_runs.h"
#include "face_edges.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

namespace pcl::acmap::test {
namespace {

/** The 2D Delaunay triangulation of points on z = 0 or z = x as sorted sets. */
Triangles
delaunay(const Points& points, ExactPlane plane)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::int32_t, Kernel>;
  using Structure = CGAL::Triangulation_data_structure_2<Vertex>;
  const double stretch = plane == ExactPlane::Level ? 1 : std::sqrt(2.0);
  std::vector<std::pair<Kernel::Point_2, std::int32_t>> flat;
  for (std::size_t i = 0; i < points.size(); ++i)
    flat.emplace_back(Kernel::Point_2(points[i].x() * stretch, points[i].y()),
                      static_cast<std::int32_t>(i));
  const CGAL::Delaunay_triangulation_2<Kernel, Structure> oracle(flat.begin(),
                                                                 flat.end());
  Triangles triangles;
  for (auto face = oracle.finite_faces_begin(); face != oracle.finite_faces_end();
       ++face)
    triangles.push_back(
        {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return asSets(std::move(triangles));
}

Triangles
within(const Points& points, Triangles triangles, double length)
{
  const EdgeAllowed allowed = noLongerThan(points, length);
  triangles.erase(std::remove_if(triangles.begin(),
                                 triangles.end(),
                                 [&](const Triangle& t) {
                                   return !allowed(t[0], t[1]) ||
                                          !allowed(t[1], t[2]) || !allowed(t[2], t[0]);
                                 }),
                  triangles.end());
  return triangles;
}

Triangles
difference(const Triangles& a, const Triangles& b)
{
  Triangles result;
  std::set_difference(
      a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

/** Would the triangle create a second fan at one of its vertices? */
bool
addsFan(const Points& points, Triangles mesh, const Triangle& triangle)
{
  mesh.push_back(triangle);
  const auto around = facesAroundVertices(mesh, points.size());
  return std::any_of(triangle.begin(), triangle.end(), [&](std::int32_t corner) {
    return countFans(mesh, around[corner], corner) > 1;
  });
}

double
area(const Points& points, const Triangles& mesh)
{
  double sum = 0;
  for (const Triangle& t : mesh)
    sum += (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm() / 2;
  return sum;
}

class DeWallOnPlane : public testing::TestWithParam<std::tuple<ExactPlane, unsigned>> {
protected:
  const ExactPlane plane_ = std::get<0>(GetParam());
  const Cloud cloud_ = makeRandomPlane(800, plane_, std::get<1>(GetParam()));
};

/** With a size constraint, the only missing Delaunay triangles within the limit are
 * those that touch the rest in a vertex only: they would violate the rule of one fan
 * per vertex. */
TEST_P(DeWallOnPlane, equalsDelaunayInsideTheSizeConstraint)
{
  for (const double length : {0.2, 0.08, 0.05}) {
    const DeWallResult result = triangulate(cloud_, {DeWallRule::Guarded, length});
    const Triangles ours = asSets(result.mesh.triangles);
    const Triangles wanted =
        within(result.points, delaunay(result.points, plane_), length);
    EXPECT_TRUE(difference(ours, wanted).empty());
    const Triangles lacking = difference(wanted, ours);
    for (const Triangle& triangle : lacking)
      EXPECT_TRUE(addsFan(result.points, ours, triangle));
    if (length > 0.1) {
      EXPECT_TRUE(lacking.empty());
    }
  }
}

TEST_P(DeWallOnPlane, equalsDelaunayWithoutLimit)
{
  for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense})
    for (const std::int32_t leaf_size : {16, 100000}) {
      const DeWallResult result = triangulateInLeaves(cloud_, {rule, 10}, leaf_size);
      EXPECT_EQ(asSets(result.mesh.triangles), delaunay(result.points, plane_))
          << nameOf(rule) << ", leaf size " << leaf_size;
    }
}

/** The smallest circle over a side belongs to another point where the Delaunay triangle has
 * an obtuse angle there: along the border, where no neighbour can build it, it is missing. */
TEST_P(DeWallOnPlane, strictlyLacksFewTriangles)
{
  const DeWallResult result = triangulate(cloud_, {DeWallRule::Strict, 10});
  const Triangles ours = asSets(result.mesh.triangles);
  const Triangles oracle = delaunay(result.points, plane_);
  EXPECT_TRUE(difference(ours, oracle).empty());
  EXPECT_LT(difference(oracle, ours).size(), oracle.size() / 20);
}

INSTANTIATE_TEST_SUITE_P(Random,
                         DeWallOnPlane,
                         testing::Combine(testing::Values(ExactPlane::Level,
                                                          ExactPlane::Inclined),
                                          testing::Values(1U, 2U, 3U)));

/** If four points are cocircular, either diagonal is Delaunay: area and empty circles
 * are compared instead. */
TEST(DeWallOnGrid, isADelaunayTriangulation)
{
  for (const ExactPlane plane : {ExactPlane::Level, ExactPlane::Inclined})
    for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense})
      for (const double length : {0.5, 1.0, 20.0})
        for (const std::int32_t leaf_size : {16, 100000}) {
          const DeWallResult result = triangulateInLeaves(
              makeGrid(30, 20, 0.25, plane), {rule, length}, leaf_size);
          MeshDemands demands;
          demands.edge_allowed = noLongerThan(result.points, length);
          demands.empty_spheres = true;
          EXPECT_EQ(checkMesh(result.points, result.mesh.triangles, demands).total(),
                    0U);
          EXPECT_EQ(result.mesh.triangles.size(), 2U * 29 * 19);
          const double slope = plane == ExactPlane::Level ? 1 : std::sqrt(2.0);
          EXPECT_NEAR(area(result.points, result.mesh.triangles),
                      29 * 19 * 0.0625 * slope,
                      1e-9);
        }
}

/** Compares with the oracle if four or more points are cocircular: any diagonals are
 * valid, so number, area and empty circles must agree. */
void
expectADelaunayTriangulation(const Cloud& cloud, ExactPlane plane)
{
  for (const DeWallRule rule : {DeWallRule::Guarded, DeWallRule::Dense})
    for (const std::int32_t leaf_size : {16, 100000}) {
      const DeWallResult result = triangulateInLeaves(cloud, {rule, 200}, leaf_size);
      const Triangles oracle = delaunay(result.points, plane);
      MeshDemands demands;
      demands.empty_spheres = true;
      EXPECT_EQ(checkMesh(result.points, result.mesh.triangles, demands).total(), 0U);
      EXPECT_EQ(result.mesh.triangles.size(), oracle.size())
          << nameOf(rule) << ", leaf size " << leaf_size;
      EXPECT_NEAR(area(result.points, result.mesh.triangles),
                  area(result.points, oracle),
                  1e-9 * area(result.points, oracle))
          << nameOf(rule) << ", leaf size " << leaf_size;
    }
}

TEST(DeWallOnCircle, fillsThePolygonWhateverTheDiagonals)
{
  for (const int radius : {5, 25, 65})
    for (const bool with_center : {false, true})
      for (const std::uint64_t order : {0U, 1U, 2U})
        expectADelaunayTriangulation(
            permuted(makeExactCircle(radius, with_center), order), ExactPlane::Level);
}

TEST(DeWallOnCircle, fillsOneOfFourPoints)
{
  Cloud square = makeGrid(2, 2, 1, ExactPlane::Inclined);
  for (const std::uint64_t order : {0U, 1U, 2U, 3U, 4U, 5U})
    expectADelaunayTriangulation(permuted(square, order), ExactPlane::Inclined);
}

TEST(DeWallOnGrid, fillsTheGapsOfARaggedGrid)
{
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U})
    for (const ExactPlane plane : {ExactPlane::Level, ExactPlane::Inclined}) {
      Cloud ragged = permuted(makeGrid(24, 24, 0.25, plane), seed);
      ragged.resize(ragged.size() / 2);
      expectADelaunayTriangulation(ragged, plane);
    }
}

} // namespace
} // namespace pcl::acmap::test
