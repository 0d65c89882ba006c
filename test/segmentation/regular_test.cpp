#include "axes.h"
#include "planes/known_planes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

constexpr double degree = M_PI / 180;

/** \param[in] deviation standard deviation of its tilt, radians */
KnownPlane
makePlane(const Eigen::Vector3d& normal, double area, double deviation)
{
  KnownPlane plane;
  PlanePatch& patch = plane.patch;
  const Eigen::Vector3d n = normal.normalized();
  patch.center = {1, 2, 3};
  patch.coefficients << n, -n.dot(patch.center);
  patch.axis_u = n.unitOrthogonal();
  patch.axis_v = n.cross(patch.axis_u);
  patch.covariance = deviation * deviation * Eigen::Matrix3d::Identity();
  patch.area = area;
  return plane;
}

Eigen::Vector3d
normalOf(const KnownPlane& plane)
{
  return plane.patch.coefficients.head<3>();
}

/** A direction that deviates from an axis by an angle in radians towards another
 * axis. */
Eigen::Vector3d
leaning(const Eigen::Vector3d& axis, const Eigen::Vector3d& towards, double angle)
{
  return std::cos(angle) * axis + std::sin(angle) * towards;
}

TEST(RegularPlanes, areParallelOrUprightToLargerOnes)
{
  std::vector<KnownPlane> planes{
      makePlane(z, 10, 0.5 * degree),
      makePlane(leaning(x, z, 0.6 * degree), 8, 0.5 * degree),
      makePlane(leaning(-z, x, 0.5 * degree), 6, 0.5 * degree),
      makePlane(leaning(y, x + z, 0.3 * degree), 4, 0.5 * degree)};
  const planes::Regularity regularity = planes::makeRegular(planes);
  EXPECT_EQ(regularity.turned, 3U);
  EXPECT_NEAR(regularity.largest_turn, 0.6 * degree, 0.05 * degree);
  EXPECT_EQ(normalOf(planes[0]), z) << "the largest one stays";
  EXPECT_NEAR(normalOf(planes[1]).dot(z), 0, 1e-12);
  EXPECT_TRUE(normalOf(planes[2]).isApprox(-z, 1e-12)) << "it keeps its side";
  EXPECT_NEAR(normalOf(planes[3]).dot(normalOf(planes[0])), 0, 1e-12);
  EXPECT_NEAR(normalOf(planes[3]).dot(normalOf(planes[1])), 0, 1e-12);
  for (const KnownPlane& plane : planes) {
    const PlanePatch& patch = plane.patch;
    EXPECT_NEAR(normalOf(plane).dot(patch.center) + patch.coefficients[3], 0, 1e-12);
    EXPECT_NEAR(patch.axis_u.cross(patch.axis_v).dot(normalOf(plane)), 1, 1e-12);
  }
}

TEST(RegularPlanes, stayWhereTheyAreSureToBeAskew)
{
  std::vector<KnownPlane> planes{
      makePlane(z, 10, 0.05 * degree),
      makePlane(leaning(x, z, 0.6 * degree), 8, 0.05 * degree)};
  const Eigen::Vector3d before = normalOf(planes[1]);
  EXPECT_EQ(planes::makeRegular(planes).turned, 0U);
  EXPECT_EQ(normalOf(planes[1]), before);
}

TEST(RegularPlanes, turnByADegreeAtMost)
{
  for (const double angle : {0.9, 1.1}) {
    std::vector<KnownPlane> planes{
        makePlane(z, 10, std::nan("")),
        makePlane(leaning(x, z, angle * degree), 8, std::nan(""))};
    EXPECT_EQ(planes::makeRegular(planes).turned, angle < 1 ? 1U : 0U) << angle;
  }
  std::vector<KnownPlane> none;
  EXPECT_EQ(planes::makeRegular(none).turned, 0U);
}

/** To be perpendicular to two planes that are 60 degrees apart, it would have to turn
 * twice as far. */
TEST(RegularPlanes, turnByTheirOwnUncertaintyAtMost)
{
  const double deviation = 0.1 * degree, part = 2.9 * deviation;
  const Eigen::Vector3d aside = leaning(z, x, 60 * degree);
  // deviates from the perpendicular to z by part, to the other one by -part
  const Eigen::Vector3d skew = y + part * z - 1.5 * part / std::sin(60 * degree) * x;
  std::vector<KnownPlane> planes{makePlane(z, 10, deviation),
                                 makePlane(aside, 8, deviation),
                                 makePlane(skew, 6, deviation)};
  const Eigen::Vector3d before = normalOf(planes[2]);
  EXPECT_LT(std::abs(before.dot(aside)), 3 * deviation);
  EXPECT_EQ(planes::makeRegular(planes).turned, 1U);
  EXPECT_NEAR(normalOf(planes[2]).dot(z), 0, 1e-12) << "to the larger one";
  EXPECT_LE(normalOf(planes[2]).cross(before).norm(), 3 * deviation);
}

} // namespace
} // namespace pcl::acmap::test
