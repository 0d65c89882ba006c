#include <pcl/exceptions.h>
#include <pcl/simulation/scene_geometry.h>
#include <pcl/simulation/surface_color.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

const SimulatedRectangle sound{{0, 0, 2}, {1, 0, 0}, {0, 1, 0}};

TEST(SceneGeometry, RectanglesOfOnePlaneAddUp)
{
  SceneGeometry scene;
  scene.addRectangle("a", "wall", sound, {});
  scene.addRectangle("b", "wall", {{3, 0, 2}, {0, -2, 0}, {0.5, 0, 0}}, {});
  scene.addRectangle("c", "other", {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {});
  ASSERT_EQ(scene.planes().size(), 2u);
  EXPECT_EQ(scene.planes()[0].rectangles.size(), 2u);
  EXPECT_NEAR(scene.planes()[0].area(), 2.0, 1e-12);
  EXPECT_TRUE(scene.planes()[0].coefficients.isApprox(Eigen::Vector4d(0, 0, 1, -2)));
  EXPECT_EQ(scene.surfaces()[2].plane, 1);
}

TEST(SceneGeometry, InconsistentPlanesAreRefusedAndLeaveNothing)
{
  SceneGeometry scene;
  scene.addRectangle("a", "wall", sound, {});
  const auto refused = [&](const SimulatedRectangle& rectangle) {
    EXPECT_THROW(scene.addRectangle("b", "wall", rectangle, {}), BadArgumentException);
  };
  refused({{0, 0, 2.00001}, {1, 0, 0}, {0, 1, 0}});
  refused({{0, 0, 2}, {0, 1, 0}, {1, 0, 0}}); // faces the opposite direction
  refused({{0, 0, 2}, {1, 0, 0}, {0, 0, 1}});
  EXPECT_EQ(scene.surfaces().size(), 1u);
  EXPECT_EQ(scene.planes()[0].rectangles.size(), 1u);
}

TEST(SceneGeometry, DegenerateSurfacesAreRefused)
{
  SceneGeometry scene;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](const SimulatedRectangle& rectangle) {
    EXPECT_THROW(scene.addRectangle("a", "a", rectangle, {}), BadArgumentException);
  };
  refused({{0, 0, 0}, {0, 0, 0}, {0, 1, 0}});
  refused({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}});
  refused({{0, 0, 0}, {1, 0, 0}, {0.1, 1, 0}});
  refused({{0, 0, nan}, {1, 0, 0}, {0, 1, 0}});
  refused({{0, 0, 1e9}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_THROW(scene.addBox("b", {0, 0, 0}, {1, 0, 1}, {}), BadArgumentException);
  EXPECT_THROW(scene.addBox("b", {0, 0, 0}, {1, -1, 1}, {}), BadArgumentException);
  EXPECT_THROW(scene.addCylinder("c", {{0, 0, 0}, {0, 1, 0}, 0.0}, {}, true),
               BadArgumentException);
  EXPECT_THROW(scene.addCylinder("c", {{0, 0, 0}, {0, 0, 0}, 1.0}, {}, true),
               BadArgumentException);
  EXPECT_THROW(scene.addRectangle("t", "t", sound, {{0, 0, 0}, -1.0}),
               BadArgumentException);
  EXPECT_TRUE(scene.surfaces().empty());
  EXPECT_TRUE(scene.planes().empty());
}

TEST(SceneGeometry, BoxesLookOutwards)
{
  SceneGeometry scene;
  const Eigen::Vector3d minimum(1, 2, 3), maximum(2, 4, 6);
  scene.addBox("box", minimum, maximum, {});
  ASSERT_EQ(scene.planes().size(), 6u);
  const Eigen::Vector3d middle = 0.5 * (minimum + maximum);
  double area = 0;
  for (const TruthPlane& plane : scene.planes()) {
    EXPECT_LT(plane.coefficients.head<3>().dot(middle) + plane.coefficients[3], 0.0)
        << plane.name;
    area += plane.area();
  }
  EXPECT_NEAR(area, 2 * (1 * 2 + 2 * 3 + 1 * 3), 1e-12);
  EXPECT_EQ(scene.planes()[2].name, "box top");
  EXPECT_EQ(scene.planes()[2].coefficients[1], -1.0) << "y points down";
}

class Openings : public testing::Test {
protected:
  Openings()
  {
    scene_.addRectangle("floor", "floor", {{0, 0, 0}, {-4, 0, 0}, {0, 0, -5}}, {});
    openings_.name = "doors";
    openings_.floor = "floor";
  }

  void
  add()
  {
    // Faces -z, as seen from the room in front of it.
    scene_.addWall("wall", "wall", {{-4, 0, 0}, {4, 0, 0}, {0, -3, 0}}, {}, openings_);
  }

  SceneGeometry scene_;
  WallOpenings openings_;
};

TEST_F(Openings, AreCutOutAndClosedBehind)
{
  openings_.at = {0.5, 2.0};
  add();
  const auto area = [&](const std::string& name) {
    for (const TruthPlane& plane : scene_.planes())
      if (plane.name == name)
        return plane.area();
    return 0.0;
  };
  EXPECT_NEAR(area("wall"), 12 - 2 * 0.9 * 2.1, 1e-12);
  EXPECT_NEAR(area("doors"), 2 * 0.9 * 2.1, 1e-12);
  EXPECT_NEAR(area("doors heads"), 2 * 0.9 * 0.1, 1e-12);
  EXPECT_NEAR(area("doors 1 near side"), 2.1 * 0.1, 1e-12);
  EXPECT_NEAR(area("doors 2 far side"), 2.1 * 0.1, 1e-12);
  EXPECT_NEAR(area("floor"), 20 + 2 * 0.9 * 0.1, 1e-12);
}

TEST_F(Openings, ThatDoNotFitAreRefused)
{
  const auto refused = [&](std::vector<double> at) {
    openings_.at = std::move(at);
    EXPECT_THROW(add(), BadArgumentException);
  };
  refused({-0.1});
  refused({3.5});
  refused({0.5, 1.0});
  refused({2.0, 0.5});
  openings_.height = 3.0;
  refused({0.5});
  openings_.height = 2.1;
  openings_.depth = 0.0;
  refused({0.5});
  openings_.depth = 0.1;
  openings_.floor = "cellar";
  refused({0.5});
  EXPECT_EQ(scene_.surfaces().size(), 1u);
}

TEST(TruthPlane, MovesWithItsPoints)
{
  TruthPlane plane;
  plane.coefficients << 0, 0, 1, -2;
  plane.rectangles = {sound};
  Eigen::Isometry3d motion(
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  motion.translation() = Eigen::Vector3d(4, -5, 6);
  const TruthPlane moved = transformPlane(plane, motion);
  for (const Eigen::Vector3d& point :
       {Eigen::Vector3d(0, 0, 2), Eigen::Vector3d(7, -3, 2.5)}) {
    const double before = plane.coefficients.dot(point.homogeneous());
    EXPECT_NEAR(moved.coefficients.dot((motion * point).homogeneous()), before, 1e-12);
  }
  EXPECT_NEAR(moved.area(), plane.area(), 1e-12);
  EXPECT_TRUE(moved.rectangles[0].corner.isApprox(motion * sound.corner));
}

TEST(SurfaceColor, IsOfThePlaceAlone)
{
  SimulatedSurface surface{"wall", sound, 0, {{100, 128, 200}, 20.0}};
  const Eigen::Vector3d place(0.3, 0.4, 2);
  EXPECT_EQ(surfaceColor(surface, 3, place), surfaceColor(surface, 3, place));
  EXPECT_TRUE(surfaceCoordinates(surface, place).isApprox(Eigen::Vector2d(0.3, 0.4)));
  int differing = 0;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d elsewhere(0.05 * i, 0.5, 2);
    differing +=
        surfaceColor(surface, 3, elsewhere) != surfaceColor(surface, 4, elsewhere);
  }
  EXPECT_GT(differing, 15);
  surface.look.texture = 0.0;
  EXPECT_EQ(surfaceColor(surface, 3, place), surface.look.color);
}

TEST(SurfaceCoordinates, RunRoundACylinder)
{
  const SimulatedSurface column{
      "column", SimulatedCylinder{{1, 0, 0}, {0, -2, 0}, 0.5}, -1, {}};
  const Eigen::Vector2d a = surfaceCoordinates(column, {1.5, -1, 0});
  const Eigen::Vector2d b = surfaceCoordinates(column, {1, -1.5, 0.5});
  EXPECT_NEAR(a.y(), 1.0, 1e-12);
  EXPECT_NEAR(b.y(), 1.5, 1e-12);
  const double around = std::abs(a.x() - b.x());
  const double quarter = 0.25 * M_PI;
  EXPECT_NEAR(std::min(around, 4 * quarter - around), quarter, 1e-12);
}

} // namespace
} // namespace pcl::acmap::test
