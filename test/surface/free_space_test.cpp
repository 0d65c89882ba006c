#include "clouds.h"

#include <pcl/core/random.h>
#include <pcl/surface/dewall_triangulation.h>

#include <algorithm>
#include <limits>
#include <optional>

#ifdef ACMAP_FEW_POINT_TYPES
#include <pcl/surface/impl/dewall_triangulation.hpp>
#endif

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector3d;

/** Rectangles of points, with gaps between them so that they are not connected, each with the side it is seen from. */
class Scene {
public:
  /** Adds a rectangle with two sides; it is seen from the side of their cross product. */
  Scene&
  add(const Vector3d& corner, const Vector3d& right, const Vector3d& ahead)
  {
    const Vector3d normal = right.cross(ahead).normalized();
    const auto steps = [](const Vector3d& side) {
      return static_cast<int>(side.norm() / spacing);
    };
    for (int i = 3; i < steps(right) - 1; ++i)
      for (int j = 3; j < steps(ahead) - 1; ++j) {
        const Vector3d jitter(
            random_.uniform(-0.2, 0.2), random_.uniform(-0.2, 0.2), 0);
        const Vector3d place = corner +
                               (i + jitter.x()) * spacing * right.normalized() +
                               (j + jitter.y()) * spacing * ahead.normalized();
        cloud.push_back(toPoint(place));
        sides_.push_back(normal);
      }
    return *this;
  }

  /** Floor, ceiling and four walls, seen from inside.
   * \param[in] corner the lowest one */
  Scene&
  addRoom(const Vector3d& corner, const Vector3d& size)
  {
    const Vector3d x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
    add(corner, x, y).add(corner + z, y, x);
    add(corner, y, z).add(corner, z, x);
    return add(corner + x, z, y).add(corner + y, x, z);
  }

  /** Four walls, seen from outside. */
  Scene&
  addFacades(const Vector3d& corner, const Vector3d& size)
  {
    const Vector3d x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
    add(corner, z, y).add(corner, x, z);
    return add(corner + x, y, z).add(corner + y, z, x);
  }

  /** Number of triangles, and of those that show their backs. */
  std::pair<std::size_t, std::size_t>
  countBacks(const TriangleMesh& mesh) const
  {
    const auto backs = std::count_if(
        mesh.triangles.begin(),
        mesh.triangles.end(),
        [&](const TriangleMesh::Triangle& t) {
          const auto at = [&](std::size_t i) {
            return Vector3d(
                cloud[static_cast<std::size_t>(t[i])].getVector3fMap().cast<double>());
          };
          return (at(1) - at(0))
                     .cross(at(2) - at(0))
                     .dot(rotation_ * sides_[static_cast<std::size_t>(t[0])]) < 0;
        });
    return {mesh.triangles.size(), static_cast<std::size_t>(backs)};
  }

  void
  move(const Eigen::Isometry3d& motion)
  {
    cloud = moved(cloud, motion);
    rotation_ = motion.linear();
  }

  static constexpr double spacing = 0.1; // metres
  Cloud cloud;

private:
  Random random_{7};
  std::vector<Vector3d> sides_;
  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Identity();
};

TriangleMesh
meshOf(const Cloud& cloud,
       const std::optional<Vector3d>& up,
       DeWallRule rule = DeWallRule::Guarded,
       unsigned threads = 2)
{
  DeWallTriangulation<PointXYZ> dewall;
  if (up)
    dewall.setUpDirection(*up);
  dewall.setAcceptanceRule(rule);
  dewall.setMaximumEdgeLength(2.5 * Scene::spacing);
  dewall.setNumberOfThreads(threads);
  dewall.setInputCloud(cloud.makeShared());
  TriangleMesh mesh;
  dewall.reconstruct(mesh);
  return mesh;
}

/** Two storeys of two rooms each, with walls of 40 cm, a table and a chest. */
Scene
makeBuilding()
{
  Scene scene;
  for (const double height : {0.0, 2.9})
    for (const double east : {0.0, 5.4})
      scene.addRoom({east, 0, height}, {5, 4, 2.5});
  scene.add({1, 1, 0.75}, {1.5, 0, 0}, {0, 1, 0});
  scene.add({7.2, 1.5, 1}, {1, 0, 0}, {0, 1, 0});
  return scene.addFacades({7.2, 1.5, 0}, {1, 1, 1});
}

TEST(FreeSpace, roomsFaceInwardsWhereverTheOriginIs)
{
  for (const Vector3d& origin : {Vector3d(0, 0, 0), Vector3d(-30, 2, 9)}) {
    Scene scene = makeBuilding();
    scene.move(Eigen::Isometry3d(Eigen::Translation3d(origin)));
    const auto [faces, backs] =
        scene.countBacks(meshOf(scene.cloud, Vector3d(0, 0, 2)));
    EXPECT_GT(faces, 20000U);
    EXPECT_EQ(backs, 0U);
    EXPECT_GT(scene.countBacks(meshOf(scene.cloud, {})).second, faces / 10)
        << "the scene needs no up direction";
  }
}

TEST(FreeSpace, isTheSameInEveryFrame)
{
  Scene scene = makeBuilding();
  const Eigen::Isometry3d motion = makeRandomMotion(3, 50);
  scene.move(motion);
  const Vector3d up = motion.linear() * Vector3d::UnitZ();
  EXPECT_EQ(scene.countBacks(meshOf(scene.cloud, up)).second, 0U);
}

TEST(FreeSpace, groundRoofsAndFacadesAreSeenFromTheAir)
{
  Scene scene;
  scene.add({0, 0, 0}, {30, 0, 0}, {0, 10, 0}).add({0, 18, 0}, {30, 0, 0}, {0, 10, 0});
  scene.add({0, 10, 0}, {5, 0, 0}, {0, 8, 0}).add({11, 10, 0}, {7, 0, 0}, {0, 8, 0});
  scene.add({24, 10, 0}, {6, 0, 0}, {0, 8, 0});
  scene.addFacades({5, 10, 0}, {6, 8, 5}).addFacades({18, 10, 0}, {6, 8, 4});
  scene.add({5, 10, 5}, {6, 0, 0}, {0, 4, 3}).add({5, 14, 8}, {6, 0, 0}, {0, 4, -3});
  scene.add({18, 10, 4}, {6, 0, 0}, {0, 8, 0});
  for (const double height : {-1000.0, 1123.0}) {
    scene.move(Eigen::Isometry3d(Eigen::Translation3d(0, 0, height)));
    EXPECT_EQ(scene.countBacks(meshOf(scene.cloud, Vector3d::UnitZ())).second, 0U)
        << height;
  }
}

TEST(FreeSpace, groundFacesUpWithEveryRule)
{
  Scene scene;
  scene.add({0, 0, 100}, {10, 0, 0}, {0, 10, 1});
  for (const DeWallRule rule :
       {DeWallRule::Guarded, DeWallRule::Dense, DeWallRule::Strict}) {
    const auto [faces, backs] =
        scene.countBacks(meshOf(scene.cloud, Vector3d::UnitZ(), rule));
    EXPECT_GT(faces, 10000U);
    EXPECT_EQ(backs, 0U);
    EXPECT_EQ(scene.countBacks(meshOf(scene.cloud, {}, rule)).second, faces)
        << "it is seen from the origin, below";
  }
}

TEST(FreeSpace, sameBytesWithEveryNumberOfThreads)
{
  const Scene scene = makeBuilding();
  const TriangleMesh expected =
      meshOf(scene.cloud, Vector3d::UnitZ(), DeWallRule::Guarded, 1);
  for (const unsigned threads : {2U, 5U})
    EXPECT_EQ(
        meshOf(scene.cloud, Vector3d::UnitZ(), DeWallRule::Guarded, threads).triangles,
        expected.triangles);
}

TEST(FreeSpace, outlierFarAboveIsNoCeiling)
{
  Scene scene;
  scene.add({0, 0, 5}, {3, 0, 0}, {0, 3, 0});
  const auto [faces, backs] =
      scene.countBacks(meshOf(withOutlier(scene.cloud, 1e7F), Vector3d::UnitZ()));
  EXPECT_GT(faces, 1000U);
  EXPECT_EQ(backs, 0U);
}

TEST(FreeSpace, refusesDirectionsWithoutLength)
{
  DeWallTriangulation<PointXYZ> dewall;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(dewall.setUpDirection({0, 0, 0}), BadArgumentException);
  EXPECT_THROW(dewall.setUpDirection({0, nan, 1}), BadArgumentException);
  EXPECT_FALSE(dewall.getUpDirection());
  dewall.setUpDirection({0, 0, 3});
  EXPECT_EQ(dewall.getUpDirection(), Vector3d::UnitZ());
  dewall.resetUpDirection();
  EXPECT_FALSE(dewall.getUpDirection());
}

} // namespace
} // namespace pcl::acmap::test
