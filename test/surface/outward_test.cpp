#include "clouds.h"

#include <pcl/core/random.h>
#include <pcl/surface/dewall_triangulation.h>

#ifdef ACMAP_FEW_POINT_TYPES
#include <pcl/surface/impl/dewall_triangulation.hpp>
#endif

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

/** Points of a ball, even up to the jitter. */
Cloud
makeBall(const Eigen::Vector3d& center, double radius)
{
  constexpr int points = 3000;
  Cloud cloud;
  for (int i = 0; i < points; ++i) {
    const double z = 1 - (2 * i + 1.0) / points, turn = i * M_PI * (3 - std::sqrt(5.0));
    const double across = std::sqrt(1 - z * z);
    cloud.push_back(toPoint(center + radius * Eigen::Vector3d(across * std::cos(turn),
                                                              across * std::sin(turn),
                                                              z)));
  }
  return cloud;
}

/** Fraction of the area that faces away from a place. */
double
shareFacingAwayFrom(const Eigen::Vector3d& place,
                    const Cloud& cloud,
                    const TriangleMesh& mesh)
{
  double away = 0, all = 0;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const auto corner = [&](std::size_t k) -> Eigen::Vector3d {
      return cloud[static_cast<std::size_t>(t[k])].getVector3fMap().cast<double>();
    };
    const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    away += normal.dot(corner(0) - place) > 0 ? normal.norm() : 0;
    all += normal.norm();
  }
  return away / all;
}

DeWallTriangulation<PointXYZ>
dewallOf(const Cloud& cloud)
{
  DeWallTriangulation<PointXYZ> dewall;
  dewall.setInputCloud(cloud.makeShared());
  return dewall;
}

TEST(Outward, isAClosedObjectWithoutASensor)
{
  for (const Eigen::Vector3d& center : {Eigen::Vector3d(0, 0, 0),
                                        Eigen::Vector3d(0.2, 0, 0),
                                        Eigen::Vector3d(7, -3, 1)}) {
    const Cloud cloud = makeBall(center, 0.6);
    DeWallTriangulation<PointXYZ> dewall = dewallOf(cloud);
    TriangleMesh mesh;
    dewall.reconstruct(mesh);
    EXPECT_EQ(dewall.getReport().sides, DeWallSides::Outward);
    EXPECT_GT(shareFacingAwayFrom(center, cloud, mesh), 0.999);
  }
}

TEST(Outward, isNotWhatMayBeARoomOrIsOpen)
{
  const Cloud room = makeBall({1, 1, 0}, 3);
  Cloud open;
  for (const PointXYZ& point : makeBall({2, 0, 0}, 0.6))
    if (point.z > 0.3F)
      open.push_back(point);
  for (const Cloud& cloud : {room, open}) {
    DeWallTriangulation<PointXYZ> dewall = dewallOf(cloud);
    TriangleMesh mesh;
    dewall.reconstruct(mesh);
    EXPECT_EQ(dewall.getReport().sides, DeWallSides::Undetermined);
  }
}

TEST(Outward, isWhatIsStated)
{
  for (const DeWallRule rule :
       {DeWallRule::Guarded, DeWallRule::Dense, DeWallRule::Strict}) {
    Cloud cloud = makeBall({1, 1, 0}, 3);
    cloud.sensor_origin_ << 1, 1, 0, 1;
    DeWallTriangulation<PointXYZ> dewall = dewallOf(cloud);
    dewall.setAcceptanceRule(rule);
    TriangleMesh mesh;
    dewall.reconstruct(mesh);
    EXPECT_EQ(dewall.getReport().sides, DeWallSides::Sensor);
    EXPECT_LT(shareFacingAwayFrom({1, 1, 0}, cloud, mesh), 0.001);
    dewall.setOutward(true);
    dewall.reconstruct(mesh);
    EXPECT_EQ(dewall.getReport().sides, DeWallSides::Outward);
    EXPECT_GT(shareFacingAwayFrom({1, 1, 0}, cloud, mesh), 0.999);
  }
}

} // namespace
} // namespace pcl::acmap::test
