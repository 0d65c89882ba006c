#include <pcl/core/cylinder_facets.h>
#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

/** A cylinder turned in space, with its middle away from the origin. */
CylinderPatch
makeCylinder(double radius, double arc, bool is_hollow)
{
  CylinderPatch cylinder;
  cylinder.axis_point = {2, -1, 5};
  cylinder.axis_direction = Eigen::Vector3d(1, 2, 2) / 3;
  cylinder.axis_u = Eigen::Vector3d(2, 1, -2) / 3;
  cylinder.axis_v = cylinder.axis_direction.cross(cylinder.axis_u);
  cylinder.radius = radius;
  cylinder.low = -1;
  cylinder.high = 2;
  cylinder.arc = arc;
  cylinder.is_hollow = is_hollow;
  return cylinder;
}

double
distanceToAxis(const CylinderPatch& cylinder, const Eigen::Vector3d& point)
{
  return (point - cylinder.axis_point).cross(cylinder.axis_direction).norm();
}

TEST(CylinderFacets, areWithinTheToleranceOfTheCylinder)
{
  for (const double radius : {0.02, 0.3, 10.0})
    for (const double arc : {0.4, 3.0, 2 * M_PI})
      for (const bool is_hollow : {false, true})
        for (const double tolerance : {1e-3, 1e-4}) {
          const CylinderPatch cylinder = makeCylinder(radius, arc, is_hollow);
          const auto facets = facetsOfCylinder(cylinder, tolerance);
          double area = 0;
          for (const PlanePatch& facet : facets) {
            ASSERT_EQ(facet.polygons.size(), 1U);
            const auto& outer = facet.polygons[0].outer;
            ASSERT_EQ(outer.size(), 4U);
            for (const Eigen::Vector3f& corner : outer) {
              const Eigen::Vector3d place = corner.cast<double>();
              EXPECT_NEAR(distanceToAxis(cylinder, place), radius, 1e-5);
              EXPECT_NEAR(facet.coefficients.head<3>().dot(place) +
                              facet.coefficients[3],
                          0,
                          1e-5);
            }
            EXPECT_GE(distanceToAxis(cylinder, facet.center),
                      radius - tolerance - 1e-9);
            area += facet.area;
          }
          EXPECT_LE(area, arc * radius * 3);
          EXPECT_GT(area, 0.95 * arc * radius * 3);
        }
}

TEST(CylinderFacets, lookToTheSideFromWhichTheyWereSeen)
{
  for (const bool is_hollow : {false, true})
    for (const PlanePatch& facet :
         facetsOfCylinder(makeCylinder(0.3, 2.5, is_hollow))) {
      const Eigen::Vector3d normal = facet.coefficients.head<3>();
      const Eigen::Vector3d from = facet.center - makeCylinder(1, 1, false).axis_point;
      EXPECT_EQ(normal.dot(from) > 0, !is_hollow);
      EXPECT_NEAR(normal.norm(), 1, 1e-12);
      EXPECT_NEAR(facet.axis_u.cross(facet.axis_v).dot(normal), 1, 1e-12);
      const auto& outer = facet.polygons[0].outer;
      const Eigen::Vector3f turn =
          (outer[1] - outer[0]).cross(outer[2] - outer[1]).normalized();
      EXPECT_GT(turn.cast<double>().dot(normal), 0.999) << "counter-clockwise";
    }
}

TEST(CylinderFacets, ofAClosedCylinderAreARing)
{
  const auto facets = facetsOfCylinder(makeCylinder(0.3, 2 * M_PI, false));
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const auto& outer = facets[i].polygons[0].outer;
    const auto& next = facets[(i + 1) % facets.size()].polygons[0].outer;
    EXPECT_EQ(outer[1], next[0]);
    EXPECT_EQ(outer[2], next[3]);
  }
}

TEST(CylinderFacets, areNeitherTooFewNorTooMany)
{
  EXPECT_EQ(facetsOfCylinder(makeCylinder(1e-4, 2 * M_PI, false)).size(), 12U);
  EXPECT_EQ(facetsOfCylinder(makeCylinder(1e6, 2 * M_PI, false)).size(), 720U);
  EXPECT_EQ(facetsOfCylinder(makeCylinder(1e6, 1e-6, true)).size(), 1U);
}

TEST(CylinderFacets, ofNothingAreNone)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : {0.0, -1.0, nan}) {
    EXPECT_TRUE(facetsOfCylinder(makeCylinder(value, 1, false)).empty());
    EXPECT_TRUE(facetsOfCylinder(makeCylinder(1, value, false)).empty());
  }
  CylinderPatch cylinder = makeCylinder(1, 1, false);
  cylinder.high = cylinder.low;
  EXPECT_TRUE(facetsOfCylinder(cylinder).empty());
  for (const double value : {nan, 1e300}) {
    cylinder = makeCylinder(1, 1, false);
    cylinder.axis_point.y() = value;
    EXPECT_TRUE(facetsOfCylinder(cylinder).empty());
  }
  EXPECT_TRUE(facetsOfCylinder(CylinderPatch()).empty());
  for (const double tolerance : {0.0, -1.0, nan})
    EXPECT_THROW(facetsOfCylinder(makeCylinder(1, 1, false), tolerance),
                 BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
