#include "small_scenes.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/rigid_alignment.h>
#include <pcl/core/random.h>
#include <pcl/simulation/ray_casting.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>

namespace pcl::acmap::test {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

struct Ray {
  Eigen::Vector3d from;
  Eigen::Vector3d along; // unit length
};

/** Distance to each kind of surface, with other formulas than in the library. */
struct SlowDistance {
  const Ray& ray;

  double
  operator()(const SimulatedRectangle& rectangle) const
  {
    Eigen::Matrix3d system;
    system << ray.along, -rectangle.edge_u, -rectangle.edge_v;
    const Eigen::Vector3d t = system.fullPivLu().solve(rectangle.corner - ray.from);
    const bool inside = t[1] >= 0 && t[1] <= 1 && t[2] >= 0 && t[2] <= 1;
    return t[0] > 0 && inside ? t[0] : none;
  }

  double
  operator()(const SimulatedDisc& disc) const
  {
    const Eigen::Hyperplane<double, 3> plane(disc.normal, disc.center);
    const Eigen::ParametrizedLine<double, 3> line(ray.from, ray.along);
    const double t = line.intersectionParameter(plane);
    return t > 0 && (line.pointAt(t) - disc.center).norm() <= disc.radius ? t : none;
  }

  double
  operator()(const SimulatedCylinder& cylinder) const
  {
    // In a frame with z along the axis: x^2 + y^2 = r^2.
    Eigen::Isometry3d frame(smallestRotation(cylinder.axis, Eigen::Vector3d::UnitZ()));
    frame.translation() = -(frame.linear() * cylinder.base);
    const Eigen::Vector3d o = frame * ray.from;
    const Eigen::Vector3d d = frame.linear() * ray.along;
    const double a = d.x() * d.x() + d.y() * d.y();
    const double p = (o.x() * d.x() + o.y() * d.y()) / a;
    const double q =
        (o.x() * o.x() + o.y() * o.y() - cylinder.radius * cylinder.radius) / a;
    if (p * p < q)
      return none;
    for (const double sign : {-1.0, 1.0}) {
      const double t = -p + sign * std::sqrt(p * p - q);
      const double height = o.z() + t * d.z();
      if (t > 0 && height >= 0 && height <= cylinder.axis.norm())
        return t;
    }
    return none;
  }
};

double
slowDistance(const SceneGeometry& scene, const Ray& ray)
{
  double nearest = none;
  for (const SimulatedSurface& surface : scene.surfaces())
    nearest = std::min(nearest, std::visit(SlowDistance{ray}, surface.shape));
  return nearest;
}

/** Compares all pixels. If a ray is so close to an edge that rounding matters, it
 * suffices that a neighbouring ray agrees. */
void
expectAsBruteForce(const SceneGeometry& scene,
                   const TrinocularRig& rig,
                   const Eigen::Isometry3d& pose)
{
  const SurfaceImage image = castView(scene, rig, pose);
  std::size_t wrong = 0;
  for (int row = 0; row < rig.height; ++row)
    for (int column = 0; column < rig.width; ++column) {
      const auto pixel = static_cast<std::size_t>(row * rig.width + column);
      const double cast =
          std::isnan(image.distance[pixel]) ? none : image.distance[pixel];
      bool agrees = false;
      for (const double shift : {0.0, 1e-8, -1e-8}) {
        const Eigen::Vector3d along =
            pixelRay(rig, column, row) + Eigen::Vector3d(shift, 0.7 * shift, 0);
        const double slow =
            slowDistance(scene, {pose.translation(), pose.linear() * along});
        agrees = cast == slow || std::abs(cast - slow) < 1e-5;
        if (agrees)
          break;
      }
      wrong += agrees ? 0 : 1;
      EXPECT_EQ(image.surface[pixel] < 0, cast == none);
    }
  EXPECT_EQ(wrong, 0u);
}

Eigen::Isometry3d
randomPose(Random& random)
{
  const Eigen::Quaterniond rotation(
      random.normal(), random.normal(), random.normal(), random.normal());
  Eigen::Isometry3d pose(rotation.normalized());
  pose.translation() = Eigen::Vector3d(
      random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3));
  return pose;
}

TEST(RayCasting, AgreesWithBruteForceInClutter)
{
  Random random(5);
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    expectAsBruteForce(clutter(seed), smallRig(40), randomPose(random));
}

TEST(RayCasting, AgreesWithBruteForceInBuildings)
{
  for (const char* name : {"corridor", "office"}) {
    const SimulatedScene scene = smallScene(name, 32);
    for (std::size_t view = 0; view < scene.views.size(); view += 17)
      expectAsBruteForce(scene.geometry, scene.rig, scene.views[view]);
  }
}

TEST(RayCasting, WideAnglesAndOddCentresAreNoMatter)
{
  TrinocularRig wide = smallRig(40);
  wide.focal_length = 8;
  wide.center_x = -5;
  wide.center_y = 45;
  Random random(6);
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    expectAsBruteForce(clutter(seed), wide, randomPose(random));
}

TEST(RayCasting, DistanceRunsAlongTheRay)
{
  const SimulatedScene scene = wallAt(2.0);
  const SurfaceImage image = castView(scene.geometry, scene.rig, scene.views[0]);
  EXPECT_NEAR(image.distance[0] * pixelRay(scene.rig, 0, 0).z(), 2.0, 1e-12);
  EXPECT_GT(image.distance[0], 2.2);
  EXPECT_NEAR(pixelRay(scene.rig, 7, 9).norm(), 1.0, 1e-15);
}

TEST(RayCasting, ReachIsADepth)
{
  const SimulatedScene scene = wallAt(2.0);
  const auto hits = [&](double reach) {
    const SurfaceImage image =
        castView(scene.geometry, scene.rig, scene.views[0], reach);
    return std::count(image.surface.begin(), image.surface.end(), 0);
  };
  EXPECT_EQ(hits(2.0 + 1e-9), scene.rig.width * scene.rig.height);
  EXPECT_EQ(hits(2.0 - 1e-9), 0);
  EXPECT_THROW(hits(0.0), BadArgumentException);
  EXPECT_THROW(hits(std::nan("")), BadArgumentException);
}

TEST(RayCasting, NothingIsSeenBehindTheCamera)
{
  const SimulatedScene scene = wallAt(-2.0);
  const SurfaceImage image = castView(scene.geometry, scene.rig, scene.views[0]);
  for (std::size_t pixel = 0; pixel < image.distance.size(); ++pixel) {
    EXPECT_TRUE(std::isnan(image.distance[pixel]));
    EXPECT_EQ(image.surface[pixel], -1);
  }
}

TEST(RayCasting, RectanglesThatShareAnEdgeLeaveNoCrack)
{
  SceneGeometry scene;
  for (int i = -30; i < 30; ++i)
    for (int j = -30; j < 30; ++j)
      scene.addRectangle(
          "tile", "wall", {{0.1 * i, 0.1 * j, 1}, {0.1, 0, 0}, {0, 0.1, 0}}, {});
  TrinocularRig rig = smallRig(64);
  rig.focal_length = 40; // gives rays exactly through edges and corners
  rig.center_x = 32;
  rig.center_y = 24;
  const SurfaceImage image = castView(scene, rig, Eigen::Isometry3d::Identity());
  EXPECT_EQ(std::count(image.surface.begin(), image.surface.end(), -1), 0);
}

TEST(RayCasting, ThreadsGiveTheSameBytes)
{
  const SimulatedScene scene = smallScene("office", 320);
  const auto cast = [&](unsigned threads) {
    return withThreads(
        threads, [&] { return castView(scene.geometry, scene.rig, scene.views[3]); });
  };
  const SurfaceImage once = cast(1);
  for (const unsigned threads : {1u, 2u, 8u}) {
    const SurfaceImage again = cast(threads);
    EXPECT_EQ(again.distance, once.distance);
    EXPECT_EQ(again.surface, once.surface);
  }
}

} // namespace
} // namespace pcl::acmap::test
