#include "small_scenes.h"
#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/simulation/ray_casting.h>
#include <pcl/simulation/standard_scenes.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

namespace pcl::acmap::test {
namespace {

const TruthPlane&
planeOf(const SimulatedScene& scene, const std::string& name)
{
  const auto& planes = scene.geometry.planes();
  const auto found = std::find_if(planes.begin(), planes.end(), [&](const auto& plane) {
    return plane.name == name;
  });
  if (found == planes.end())
    throw std::runtime_error("no plane " + name);
  return *found;
}

class StandardScene : public testing::TestWithParam<std::string> {
protected:
  SimulatedScene scene_ = smallScene(GetParam(), 96);
};

TEST_P(StandardScene, IsClosedAndSeenFromTheSideOfItsNormals)
{
  EXPECT_EQ(scene_.name, GetParam());
  for (const Eigen::Isometry3d& view : scene_.views) {
    const SurfaceImage image = castView(scene_.geometry, scene_.rig, view);
    EXPECT_EQ(std::count(image.surface.begin(), image.surface.end(), -1), 0);
    const std::set<std::int32_t> seen(image.surface.begin(), image.surface.end());
    for (const std::int32_t index : seen) {
      const auto& surface = scene_.geometry.surfaces()[static_cast<std::size_t>(index)];
      if (surface.plane < 0)
        continue;
      const auto& plane =
          scene_.geometry.planes()[static_cast<std::size_t>(surface.plane)]
              .coefficients;
      EXPECT_GT(plane.head<3>().dot(view.translation()) + plane[3], 0.0)
          << surface.name;
    }
  }
}

/** Large planes that are not visible in any view of a scene: behind the start or beyond
 * the end of the path. */
std::set<std::string>
unseenPlanes(const std::string& scene)
{
  if (scene == "corridor_drive")
    return {"near end", "far end"};
  if (scene == "corridor_survey")
    return {"far end"};
  if (scene == "l_corridor" || scene == "l_corridor_drive")
    return {"end of arm 1"};
  return {};
}

TEST_P(StandardScene, EveryLargePlaneIsSeenButThoseOffTheWay)
{
  constexpr double large = 3.0; // square metres
  std::set<std::int32_t> seen;
  for (const Eigen::Isometry3d& view : scene_.views) {
    const SurfaceImage image =
        castView(scene_.geometry, scene_.rig, view, scene_.sensor.reach);
    for (const std::int32_t index : image.surface)
      if (index >= 0)
        seen.insert(scene_.geometry.surfaces()[static_cast<std::size_t>(index)].plane);
  }
  for (std::size_t i = 0; i < scene_.geometry.planes().size(); ++i) {
    const TruthPlane& plane = scene_.geometry.planes()[i];
    if (plane.area() < large)
      continue;
    EXPECT_EQ(seen.count(static_cast<std::int32_t>(i)),
              1 - unseenPlanes(GetParam()).count(plane.name))
        << plane.name;
  }
}

TEST_P(StandardScene, EveryViewHasEnoughInReach)
{
  for (const Eigen::Isometry3d& view : scene_.views) {
    const SurfaceImage image =
        castView(scene_.geometry, scene_.rig, view, scene_.sensor.reach);
    const auto hits = std::count_if(image.surface.begin(),
                                    image.surface.end(),
                                    [](std::int32_t index) { return index >= 0; });
    EXPECT_GT(static_cast<std::size_t>(hits), scene_.sensor.points + 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes,
                         StandardScene,
                         testing::ValuesIn(standardSceneNames()),
                         [](const auto& info) { return info.param; });

TEST(StandardScenes, AnotherNameIsRefused)
{
  EXPECT_THROW(standardScene("castle"), BadArgumentException);
  EXPECT_THROW(standardScene(""), BadArgumentException);
}

TEST(Corridor, IsAsLongAndAsDenseAsItShouldBe)
{
  const SimulatedScene scene = standardScene("corridor");
  ASSERT_EQ(scene.views.size(), 106u);
  EXPECT_EQ(scene.rig.width * scene.rig.height, 640 * 480);
  std::size_t points = 0;
  for (std::size_t view = 0; view < scene.views.size(); ++view)
    points += scene.sensor.pointsOfView(view);
  EXPECT_EQ(points, 14697233u);
  EXPECT_EQ(scene.sensor.pointsOfView(14), 138654u);
  EXPECT_EQ(scene.sensor.pointsOfView(15), 138653u);
  EXPECT_EQ(scene.sensor.reach, 6.0);
  EXPECT_EQ(scene.views[0].translation(), Eigen::Vector3d::Zero());
  EXPECT_TRUE(
      scene.views[105].translation().isApprox(Eigen::Vector3d(0, 0, 62.4), 1e-12));
  // Positive yaw looks towards +x; the next view looks to the opposite side.
  EXPECT_NEAR(scene.views[0].linear()(0, 2), 0.5, 1e-12);
  EXPECT_NEAR(scene.views[1].linear()(0, 2), -0.5, 1e-12);
}

TEST(Corridor, ThreeViewsLookBackAtTheWallBehindTheStart)
{
  const SimulatedScene scene = standardScene("corridor");
  for (std::size_t view = 0; view < scene.views.size(); ++view)
    EXPECT_EQ(scene.views[view].linear()(2, 2) < 0, view >= 2 && view < 5) << view;
}

TEST(Corridor, HasSixLargePlanesAndDoorsThatLieBack)
{
  const SimulatedScene scene = standardScene("corridor");
  const double door = 0.9 * 2.1;
  EXPECT_NEAR(planeOf(scene, "left wall").area(), 65 * 2.7 - 8 * door, 1e-9);
  EXPECT_NEAR(planeOf(scene, "right wall").area(), 65 * 2.7 - 8 * door, 1e-9);
  EXPECT_NEAR(planeOf(scene, "floor").area(), 65 * 2.4 + 16 * 0.9 * 0.1, 1e-9);
  EXPECT_NEAR(planeOf(scene, "ceiling").area(), 65 * 2.4, 1e-9);
  EXPECT_NEAR(planeOf(scene, "near end").area(), 2.4 * 2.7, 1e-9);
  EXPECT_NEAR(planeOf(scene, "far end").area(), 2.4 * 2.7, 1e-9);
  const auto expect_plane = [&](const char* name, double x, double d) {
    EXPECT_TRUE(planeOf(scene, name).coefficients.isApprox(Eigen::Vector4d(x, 0, 0, d)))
        << name;
  };
  expect_plane("left wall", 1, 1.2);
  expect_plane("doors left", 1, 1.3);
  expect_plane("right wall", -1, 1.2);
  expect_plane("doors right", -1, 1.3);
  EXPECT_EQ(planeOf(scene, "doors left").rectangles.size(), 8u);
  EXPECT_NEAR(planeOf(scene, "doors right").area(), 8 * door, 1e-9);
  EXPECT_EQ(planeOf(scene, "doors left heads").rectangles.size(), 8u);
}

TEST(Loop, ClosesExactly)
{
  const SimulatedScene scene = standardScene("loop");
  const Trajectory trajectory = trajectoryOf(scene, scene.views.size());
  EXPECT_TRUE(trajectory.poses.back().matrix().isIdentity(1e-12));
  Eigen::AlignedBox3d way;
  for (const Eigen::Isometry3d& view : scene.views)
    way.extend(view.translation());
  EXPECT_TRUE(way.sizes().isApprox(Eigen::Vector3d(12, 0, 7)));
}

TEST(LCorridor, EndsInTheOtherArm)
{
  const SimulatedScene scene = standardScene("l_corridor");
  EXPECT_EQ(scene.views.front().translation(), Eigen::Vector3d::Zero());
  EXPECT_TRUE(
      scene.views.back().translation().isApprox(Eigen::Vector3d(12, 0, 12.8), 1e-12));
  EXPECT_GT(scene.views.back().linear()(0, 2), 0.8) << "looks along the second arm";
  EXPECT_NEAR(planeOf(scene, "floor").area(), 15 * 2.4 + 12.6 * 2.4 + 4 * 0.09, 1e-9);
}

/** In a drive, consecutive views overlap and the motion is in the viewing direction. */
TEST(Drives, StepsAreShort)
{
  for (const char* name : {"corridor_drive", "l_corridor_drive"}) {
    const SimulatedScene scene = standardScene(name);
    for (std::size_t view = 1; view < scene.views.size(); ++view) {
      const Eigen::Isometry3d step =
          scene.views[view - 1].inverse() * scene.views[view];
      const double degrees = Eigen::AngleAxisd(step.linear()).angle() * 180 / M_PI;
      EXPECT_LT(step.translation().norm(), 0.4 + 1e-9) << name << " " << view;
      EXPECT_GT(step.translation().z(), 0.34) << name << " " << view;
      EXPECT_LT(degrees, 13) << name << " " << view;
    }
  }
}

TEST(Drives, HaveTheBuildingsOfTheOthers)
{
  for (const std::string name : {"corridor", "l_corridor"}) {
    const SceneGeometry building = standardScene(name).geometry;
    const SceneGeometry driven = standardScene(name + "_drive").geometry;
    ASSERT_EQ(driven.surfaces().size(), building.surfaces().size());
    ASSERT_EQ(driven.planes().size(), building.planes().size());
    for (std::size_t i = 0; i < building.planes().size(); ++i)
      EXPECT_EQ(driven.planes()[i].coefficients, building.planes()[i].coefficients);
  }
}

/** Positions that are passed twice in opposite directions, with steps small enough to
 * estimate motion. */
TEST(Survey, GoesUpComesBackAndTurnsHome)
{
  const SimulatedScene scene = standardScene("corridor_survey");
  ASSERT_EQ(scene.views.size(), 106u);
  EXPECT_EQ(scene.sensor.pointsOfView(14), 138654u); // 14 697 233 in all
  EXPECT_EQ(scene.sensor.pointsOfView(15), 138653u);
  constexpr std::size_t up = 41, on_the_spot = 12;
  for (std::size_t i = 0; i < up; ++i) {
    const Eigen::Isometry3d& there = scene.views[i];
    const Eigen::Isometry3d& back = scene.views[up + on_the_spot + up - 1 - i];
    EXPECT_TRUE(there.translation().isApprox(back.translation(), 1e-9)) << i;
    EXPECT_GT(there.linear()(2, 2), 0.98) << i;
    EXPECT_LT(back.linear()(2, 2), -0.98) << i;
  }
  for (std::size_t view = 1; view < scene.views.size(); ++view) {
    const Eigen::Isometry3d step = scene.views[view - 1].inverse() * scene.views[view];
    EXPECT_LT(step.translation().norm(), 0.51) << view;
    EXPECT_LT(Eigen::AngleAxisd(step.linear()).angle() * 180 / M_PI, 15.1) << view;
  }
  EXPECT_TRUE(scene.views.back().isApprox(scene.views.front(), 1e-9));
}

TEST(Office, PartitionIsSeenFromBothSides)
{
  const SimulatedScene scene = smallScene("office", 96);
  const Eigen::Vector4d left = planeOf(scene, "partition left").coefficients;
  const Eigen::Vector4d right = planeOf(scene, "partition right").coefficients;
  EXPECT_TRUE(left.head<3>().isApprox(-right.head<3>()));
  EXPECT_NEAR(left[3] + right[3], -0.12, 1e-12);
  for (const char* side : {"partition left", "partition right"}) {
    std::size_t pixels = 0;
    for (const Eigen::Isometry3d& view : scene.views) {
      const SurfaceImage image =
          castView(scene.geometry, scene.rig, view, scene.sensor.reach);
      for (const std::int32_t index : image.surface)
        pixels +=
            index >= 0 && scene.geometry.surfaces()[std::size_t(index)].name == side
                ? 1
                : 0;
    }
    EXPECT_GT(pixels, 10000u) << side;
  }
}

TEST(StandardScenes, OpenByNameOrAsFiles)
{
  EXPECT_EQ(openSimulatedScene("office").views.size(),
            standardScene("office").views.size());
  const TemporaryFolder folder;
  EXPECT_THAT(
      [&] { openSimulatedScene(folder.write("castle.yaml", "rig: {}")); },
      testing::ThrowsMessage<InputFileException>(testing::HasSubstr("castle.yaml")));
  EXPECT_THAT(
      [] { openSimulatedScene("castle"); },
      testing::ThrowsMessage<InputFileException>(testing::HasSubstr("corridor, ")));
}

} // namespace
} // namespace pcl::acmap::test
