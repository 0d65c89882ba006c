#include <pcl/core/cylinder_facets.h>
#include <pcl/core/cylinder_rims.h>
#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <random>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

/** An upright column of radius 0.3 m that ends 5 cm above the floor. */
CylinderPatch
makeColumn(double arc = 2 * M_PI)
{
  CylinderPatch column;
  column.axis_point = {1, 2, 1};
  column.axis_u = -Vector3d::UnitY();
  column.axis_v = column.axis_direction.cross(column.axis_u);
  column.radius = 0.3;
  column.low = -0.95;
  column.high = 1.5;
  column.arc = arc;
  return column;
}

/** A floor of 4 by 4 m with a ragged hole round the column, counter-clockwise from above;
 * slopes by an angle about x. */
PlanePatch
makeFloor(double slope = 0, double raggedness = 0.04)
{
  PlanePatch floor;
  floor.coefficients = {0, -std::sin(slope), std::cos(slope), 0};
  const auto place = [&](double x, double y) {
    return Vector3f(static_cast<float>(x),
                    static_cast<float>(y),
                    static_cast<float>(y * std::tan(slope)));
  };
  PlanePolygon& polygon = floor.polygons.emplace_back();
  polygon.outer = {place(-1, 0), place(3, 0), place(3, 4), place(-1, 4)};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> off(-raggedness, raggedness);
  std::vector<Vector3f>& hole = polygon.holes.emplace_back();
  for (int i = 0; i < 17; ++i) {
    const double angle = -2 * M_PI * i / 17, radius = 0.3 + off(random);
    hole.push_back(place(1 + radius * std::cos(angle), 2 + radius * std::sin(angle)));
  }
  polygon.edges.assign(4 + 17, {EdgeKind::Rim, -1});
  floor.area = 16 / std::cos(slope);
  return floor;
}

double
areaOf(const std::vector<Vector3f>& loop, const Vector3d& normal)
{
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += loop[i].cast<double>().cross(loop[(i + 1) % loop.size()].cast<double>());
  return sum.dot(normal) / 2;
}

bool
holds(const std::vector<Vector3f>& loop, const Vector3f& point)
{
  return std::find(loop.begin(), loop.end(), point) != loop.end();
}

TEST(CylinderRims, floorAndColumnShareTheirRim)
{
  std::vector<CylinderPatch> cylinders{makeColumn()};
  std::vector<PlanePatch> planes{makeFloor()};
  const double hole_before = areaOf(planes[0].polygons[0].holes[0], Vector3d::UnitZ());
  planes[0].area += hole_before; // negative
  EXPECT_EQ(joinAtCylinders(0.1, cylinders, planes), 1U);
  EXPECT_EQ(cylinders[0].low, -1) << "it stands on the floor";
  EXPECT_EQ(cylinders[0].high, 1.5);
  EXPECT_NEAR(cylinders[0].area, 2 * M_PI * 0.3 * 2.5, 1e-9);
  const PlanePolygon& polygon = planes[0].polygons[0];
  const std::vector<PlanePatch> facets = facetsOfCylinder(cylinders[0]);
  ASSERT_EQ(polygon.holes[0].size(), facets.size());
  for (const PlanePatch& facet : facets) // two lower corners of each are in the hole
    for (std::size_t k : {0U, 1U})
      EXPECT_TRUE(std::any_of(
          polygon.holes[0].begin(), polygon.holes[0].end(), [&](const Vector3f& point) {
            return (point - facet.polygons[0].outer[k]).norm() < 1e-6F;
          }));
  ASSERT_EQ(polygon.edges.size(), 4 + facets.size());
  for (std::size_t i = 0; i < polygon.edges.size(); ++i) {
    EXPECT_EQ(polygon.edges[i].kind, i < 4 ? EdgeKind::Rim : EdgeKind::Arc);
    EXPECT_EQ(polygon.edges[i].neighbour, i < 4 ? -1 : 0);
  }
  EXPECT_LT(areaOf(polygon.holes[0], Vector3d::UnitZ()), 0) << "still clockwise";
  EXPECT_NEAR(planes[0].area, 16 - M_PI * 0.09, 2e-3);
}

TEST(CylinderRims, slopingPlanesMeetInAnEllipse)
{
  const double slope = 0.5;
  std::vector<CylinderPatch> cylinders{makeColumn()};
  std::vector<PlanePatch> planes{makeFloor(slope)};
  const Vector3d normal = planes[0].coefficients.head<3>();
  cylinders[0].axis_point.z() = 3;
  EXPECT_EQ(joinAtCylinders(0.1, cylinders, planes), 0U) << "beyond its end";
  cylinders[0].axis_point.z() = 2.1;
  EXPECT_EQ(joinAtCylinders(0.1, cylinders, planes), 1U);
  EXPECT_EQ(cylinders[0].low, -0.95) << "no right angle";
  for (const Vector3f& point : planes[0].polygons[0].holes[0]) {
    EXPECT_NEAR(normal.dot(point.cast<double>()), 0, 1e-6);
    EXPECT_NEAR((point - Vector3f(1, 2, 0)).head<2>().norm(), 0.3F, 1e-6F);
  }
  EXPECT_NEAR(areaOf(planes[0].polygons[0].holes[0], normal),
              -M_PI * 0.3 * 0.3 / std::cos(slope),
              2e-3);
}

/** A wall ends at a half column; only this part of its outline changes. */
TEST(CylinderRims, onlyWhatRunsRoundTheCylinderChanges)
{
  std::vector<CylinderPatch> cylinders{makeColumn(M_PI)};
  PlanePatch floor = makeFloor();
  PlanePolygon& polygon = floor.polygons[0];
  polygon.holes.clear();
  polygon.outer = {{-1, 0, 0},
                   {3, 0, 0},
                   {3, 2, 0},
                   {1.32F, 2, 0},
                   {1.2F, 1.75F, 0},
                   {1, 1.72F, 0},
                   {0.8F, 1.78F, 0},
                   {0.71F, 2, 0},
                   {-1, 2, 0}};
  polygon.edges.assign(9, {EdgeKind::Frontier, -1});
  polygon.edges[2] = {EdgeKind::Crease, 7}; // its ends stay
  std::vector<PlanePatch> planes{floor};
  EXPECT_EQ(joinAtCylinders(0.1, cylinders, planes), 1U);
  const PlanePolygon& joined = planes[0].polygons[0];
  for (const std::size_t i : {0U, 1U, 2U, 3U, 8U})
    EXPECT_TRUE(holds(joined.outer, polygon.outer[i])) << i;
  for (std::size_t i = 0; i < joined.edges.size(); ++i)
    EXPECT_EQ(joined.edges[i].neighbour == 7, joined.outer[i] == polygon.outer[2]);
  std::size_t arcs = 0;
  for (std::size_t i = 0; i < joined.edges.size(); ++i)
    if (joined.edges[i].kind == EdgeKind::Arc) {
      ++arcs;
      const Vector3d point = joined.outer[i].cast<double>();
      EXPECT_NEAR((point - Vector3d(1, 2, 0)).norm(), 0.3, 1e-6);
      EXPECT_LT(point.y(), 2.001);
    }
  EXPECT_GT(arcs, 8U);
  EXPECT_LT(arcs + 5, joined.edges.size() + 2);
}

TEST(CylinderRims, walksBackwardsAndFromAnyPoint)
{
  const PlanePatch floor = makeFloor();
  std::vector<CylinderPatch> cylinders{makeColumn()};
  std::vector<PlanePatch> first{floor};
  joinAtCylinders(0.1, cylinders, first);
  for (std::size_t shift = 1; shift < 17; ++shift) {
    std::vector<PlanePatch> planes{floor};
    auto& hole = planes[0].polygons[0].holes[0];
    std::rotate(
        hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(shift), hole.end());
    EXPECT_EQ(joinAtCylinders(0.1, cylinders, planes), 1U);
    EXPECT_EQ(planes[0].polygons[0].holes[0].size(),
              first[0].polygons[0].holes[0].size());
    EXPECT_NEAR(planes[0].area - floor.area, first[0].area - floor.area, 1e-6);
  }
}

TEST(CylinderRims, whatDoesNotMeetStays)
{
  const auto unchanged = [](const CylinderPatch& cylinder, const PlanePatch& plane) {
    std::vector<CylinderPatch> cylinders{cylinder};
    std::vector<PlanePatch> planes{plane};
    EXPECT_EQ(joinAtCylinders(0.1, cylinders, planes), 0U);
    EXPECT_EQ(planes[0].polygons[0].holes[0], plane.polygons[0].holes[0]);
    EXPECT_EQ(cylinders[0].low, cylinder.low);
  };
  CylinderPatch far = makeColumn();
  far.axis_point.x() = 2;
  unchanged(far, makeFloor());
  CylinderPatch above = makeColumn();
  above.axis_point.z() = 2;
  unchanged(above, makeFloor());
  CylinderPatch flat = makeColumn();
  flat.radius = 0;
  unchanged(flat, makeFloor());
  PlanePatch bad = makeFloor();
  bad.coefficients[3] = NAN;
  unchanged(makeColumn(), bad);
  PlanePatch along = makeFloor(); // the axis lies in the plane
  along.coefficients = {1, 0, 0, -0.7};
  unchanged(makeColumn(), along);
  std::vector<CylinderPatch> none;
  std::vector<PlanePatch> planes;
  EXPECT_EQ(joinAtCylinders(0.1, none, planes), 0U);
  EXPECT_THROW(joinAtCylinders(NAN, none, planes), BadArgumentException);
}

/** A wall of 2.5 m that ends 4 cm before a curved wall, and the floor before both. */
TEST(CylinderRims, curvedAndFlatWallsMeetInALine)
{
  CylinderPatch curved;
  curved.axis_point = {0, 0, 1.2};
  curved.axis_u = -Vector3d::UnitY();
  curved.axis_v = Vector3d::UnitX();
  curved.radius = 3;
  curved.low = -1.16;
  curved.high = 1.27;
  curved.arc = 1.2;
  curved.area = curved.arc * 3 * 2.43;
  for (Eigen::Index k = 0; k < 5; ++k)
    curved.covariance(k, k) = 1e-6 * static_cast<double>(k + 1);
  const double y = -2.5, x = std::sqrt(9 - 6.25); // where the wall meets it
  const auto at = [](double px, double py, double pz) {
    return Vector3f(
        static_cast<float>(px), static_cast<float>(py), static_cast<float>(pz));
  };
  std::vector<PlanePatch> planes(2);
  PlanePatch& wall = planes[0];
  wall.coefficients = {0, -1, 0, y};
  wall.polygons = {
      {{at(x + 0.04, y, 0), at(x + 2, y, 0), at(x + 2, y, 2.5), at(x + 0.04, y, 2.47)},
       {},
       {{EdgeKind::Crease, 1},
        {EdgeKind::Rim, -1},
        {EdgeKind::Frontier, -1},
        {EdgeKind::Rim, -1}}}};
  wall.area = 2.5 * 1.96;
  PlanePatch& floor = planes[1];
  floor.coefficients = {0, 0, 1, 0};
  floor.polygons = {{{at(x + 2, y, 0),
                      at(x + 0.04, y, 0),
                      at(1.2, -2.78, 0),
                      at(0.7, -2.95, 0),
                      at(0, -3.03, 0),
                      at(0, -5, 0),
                      at(x + 2, -5, 0)},
                     {},
                     {{EdgeKind::Crease, 0},
                      {EdgeKind::Frontier, -1},
                      {EdgeKind::Frontier, -1},
                      {EdgeKind::Frontier, -1},
                      {EdgeKind::Rim, -1},
                      {EdgeKind::Rim, -1},
                      {EdgeKind::Rim, -1}}}};
  floor.area = 10;
  std::vector<CylinderPatch> cylinders{curved};
  EXPECT_EQ(joinAtCylinders(0.1, cylinders, planes), 2U) << "a line and an arc";
  const std::vector<Vector3f>& outer = planes[0].polygons[0].outer;
  for (const std::size_t corner : {0U, 3U}) {
    EXPECT_NEAR(outer[corner].x(), x, 1e-6);
    EXPECT_NEAR(outer[corner].y(), y, 1e-6);
  }
  EXPECT_EQ(planes[0].polygons[0].edges[3].kind, EdgeKind::Arc);
  const PlanePolygon& below = planes[1].polygons[0];
  const auto shared = std::find(below.outer.begin(), below.outer.end(), outer[0]);
  ASSERT_NE(shared, below.outer.end()) << "the crease is still one";
  EXPECT_EQ(outer[0].z(), 0);
  EXPECT_EQ(below.edges[static_cast<std::size_t>(shared - below.outer.begin())].kind,
            EdgeKind::Arc);
  const CylinderPatch& joined = cylinders[0];
  const double end = std::atan2(x, 2.5);
  EXPECT_NEAR(joined.arc, 0.6 + end, 1e-6) << "one end stays";
  const Vector3d corner =
      joined.axis_point + 3 * (std::cos(joined.arc / 2) * joined.axis_u +
                               std::sin(joined.arc / 2) * joined.axis_v);
  EXPECT_NEAR((corner - Vector3d(x, y, 1.2)).norm(), 0, 1e-6);
  EXPECT_EQ(joined.low, -1.2);
  EXPECT_NEAR(joined.covariance.trace(), curved.covariance.trace(), 1e-12);
  EXPECT_NEAR(joined.covariance(4, 4), 5e-6, 1e-15);
}

/** A passage narrower than the tolerance beside the column: the arc would cross the outer
 * boundary. */
TEST(CylinderRims, polygonsThatWouldCrossThemselvesStay)
{
  PlanePatch floor = makeFloor(0, 0.001);
  for (Vector3f& point : floor.polygons[0].holes[0])
    point = Vector3f(1, 2, 0) + 0.8F * (point - Vector3f(1, 2, 0));
  for (Vector3f& point : floor.polygons[0].outer)
    if (point.x() > 2)
      point.x() = 1.28F;
  std::vector<CylinderPatch> cylinders{makeColumn()};
  std::vector<PlanePatch> planes{floor};
  EXPECT_EQ(joinAtCylinders(0.1, cylinders, planes), 0U);
  EXPECT_EQ(planes[0].polygons[0].holes[0], floor.polygons[0].holes[0]);
}

} // namespace
} // namespace pcl::acmap::test
