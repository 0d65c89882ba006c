#include "camera.h"

#include "clouds.h"

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Eigen::Vector3f>;

Points
pointsOf(const test::Cloud& cloud)
{
  Points points;
  for (const PointXYZ& p : cloud)
    points.emplace_back(p.x, p.y, p.z);
  return points;
}

/** \brief A box of points in front of a camera at the origin, which is outside the
 * box. */
Points
makeBox(const Eigen::Vector3f& middle, const Eigen::Vector3f& size)
{
  Points points = pointsOf(test::makeRandomBox(5000, 1));
  for (Eigen::Vector3f& p : points)
    p = middle + (p - Eigen::Vector3f::Constant(0.5F)).cwiseProduct(size);
  return points;
}

/** \brief Maximum extent of the projected points, 1 at the border of the picture. */
double
filled(const Camera& camera, const Points& points, double aspect)
{
  const Vector3d ahead = (camera.focus - camera.position).normalized();
  const Vector3d right = ahead.cross(camera.up);
  const double slope = std::tan(camera.view_angle / 2 * M_PI / 180);
  double maximum = 0;
  for (const Eigen::Vector3f& point : points) {
    const Vector3d d = point.cast<double>() - camera.position;
    const double depth = d.dot(ahead) * slope;
    maximum = std::max({maximum,
                        std::abs(d.dot(right)) / (depth * aspect),
                        std::abs(d.dot(camera.up)) / depth});
  }
  return maximum;
}

TEST(Camera, FitsTheSceneIntoThePicture)
{
  SceneView view;
  for (const Eigen::Vector3f& size :
       {Eigen::Vector3f(2, 1, 1), Eigen::Vector3f(1, 3, 0)}) {
    const Points points = makeBox({0, 0, 5}, size);
    const double share =
        filled(placeCamera(points, Vector3d::Zero(), view), points, 1280.0 / 960.0);
    EXPECT_LT(share, 1.05);
    EXPECT_GT(share, 0.85);
  }
}

TEST(Camera, StraysDoNotShrinkTheScene)
{
  Points points = makeBox({0, 0, 5}, {2, 1, 1});
  const Camera before = placeCamera(points, Vector3d::Zero(), {});
  points.emplace_back(1e9F, 1e9F, 1e9F);
  const Camera after = placeCamera(points, Vector3d::Zero(), {});
  EXPECT_LT((after.position - before.position).norm(), 0.2);
  EXPECT_LT(after.far, 100);
}

TEST(Camera, LooksAsTheSensorDoesButFromBeside)
{
  const Camera camera =
      placeCamera(makeBox({0, 0, 5}, {2, 1, 1}), Vector3d::Zero(), {});
  const Vector3d ahead = (camera.focus - camera.position).normalized();
  EXPECT_GT(ahead.z(), 0.9);
  EXPECT_LT(ahead.z(), 0.99);
  EXPECT_GT(ahead.y(), 0.1) << "downwards";
  EXPECT_LT(camera.up.y(), -0.9);
}

TEST(Camera, FollowsTheSensorsPose)
{
  SceneView view;
  view.sensor_origin = Eigen::Vector3f(10, 0, 0);
  view.sensor_orientation =
      Eigen::AngleAxisf(static_cast<float>(M_PI / 2), Eigen::Vector3f::UnitY());
  const Camera camera =
      placeCamera(makeBox({15, 0, 0}, {1, 1, 2}), Vector3d::Zero(), view);
  EXPECT_GT((camera.focus - camera.position).normalized().x(), 0.9);
}

TEST(Camera, SeesAnObjectFromTheSideItLooksTo)
{
  const Points points = makeBox({0, 0, 0}, {1, 1, 0.5});
  const Camera camera = placeCamera(points, 0.5 * Vector3d::UnitX(), {});
  EXPECT_GT(camera.position.x(), 0.5);
  EXPECT_GT(camera.position.z(), 0.3) << "from above";
  EXPECT_GT(camera.up.z(), 0.5);
  const Camera before = placeCamera(points, Vector3d::UnitX(), {});
  EXPECT_GT(before.position.x(), camera.position.x()) << "as one view was taken";
  EXPECT_LT(before.position.z(), camera.position.z());
  EXPECT_GT(before.position.z(), 0.1);
}

TEST(Camera, LooksAcrossTheLongerSideFromTheOrigin)
{
  SceneView view;
  view.sensor_origin.reset();
  view.up = Eigen::Vector3f::UnitZ();
  for (const float side : {-6.F, 6.F}) {
    const Camera camera =
        placeCamera(makeBox({0, side, 5}, {20, 1, 12}), Vector3d::Zero(), view);
    const Vector3d ahead = (camera.focus - camera.position).normalized();
    EXPECT_GT(ahead.y() * side, std::abs(ahead.x() * side)) << "away from the origin";
    EXPECT_LT(ahead.z(), 0) << "downwards";
    EXPECT_EQ(camera.vertical, Vector3d(Vector3d::UnitZ()));
    EXPECT_GT(camera.up.z(), 0.8) << "what stands is upright";
  }
}

TEST(Camera, GoesWhereItIsTold)
{
  SceneView view;
  view.from = {1, 2, 3};
  view.look = {1, 2, 7};
  view.up = {1, 0, 0};
  const Camera camera =
      placeCamera(makeBox({0, 0, 5}, {2, 1, 1}), Vector3d::Zero(), view);
  EXPECT_EQ(camera.position, Vector3d(1, 2, 3));
  EXPECT_EQ(camera.focus, Vector3d(1, 2, 7));
  EXPECT_NEAR(camera.up.x(), 1, 1e-6);
  EXPECT_GT(camera.near, 0);
}

TEST(Camera, StandsUprightAlsoWhereUpIsTheView)
{
  SceneView view;
  view.from = {0, 0, -1};
  view.look = {0, 0, 1};
  view.up = {0, 0, 1};
  const Camera camera = placeCamera({{0, 0, 0}}, Vector3d::Zero(), view);
  EXPECT_NEAR(camera.up.z(), 0, 1e-12);
  EXPECT_NEAR(camera.up.norm(), 1, 1e-12);
}

TEST(Camera, ManagesASinglePoint)
{
  const Camera camera = placeCamera({{0, 0, 2}}, Vector3d::Zero(), {});
  EXPECT_GT((camera.focus - camera.position).norm(), 0);
  EXPECT_LT(camera.near, camera.far);
}

TEST(Camera, RefusesViewsThatCannotBe)
{
  const Points points = {{0, 0, 1}};
  const auto refuses = [&](const SceneView& view) {
    EXPECT_THROW(placeCamera(points, Vector3d::Zero(), view), BadArgumentException);
  };
  SceneView view;
  view.width = 0;
  refuses(view);
  view = {};
  view.up = Eigen::Vector3f::Zero();
  refuses(view);
  view = {};
  view.from = view.look = Eigen::Vector3f(1, 1, 1);
  refuses(view);
  view = {};
  view.from = Eigen::Vector3f(0, NAN, 0);
  refuses(view);
}

} // namespace
} // namespace pcl::acmap
