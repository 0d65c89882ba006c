#include "light/light_pattern.h"
#include "light/lit_view.h"
#include "light/rig_simulation.h"
#include "lit_scenes.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/random.h>
#include <pcl/simulation/ray_casting.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace pcl::acmap::test {
namespace {

TrinocularFrame::Ptr
shotOf(const SimulatedScene& scene,
       const SimulatedLight& light,
       const RgbImage& pattern)
{
  const RigSimulation simulation(scene, {pattern}, light, raysOf(scene.rig));
  return simulation.shoot(simulation.cast(0), 0, 1, 1);
}

/** Expected grey level on a wall that is parallel to rig and projector. */
double
levelOnWall(const SimulatedScene& scene,
            const SimulatedLight& light,
            const LightPattern& pattern,
            const Eigen::Vector3d& point,
            int channel)
{
  const SimulatedProjector& projector = light.projector;
  const Eigen::Vector3d there = point - projector.T_reference_projector.translation();
  const double u = projector.focal_length * there.x() / there.z() + projector.center_x;
  const double v = projector.focal_length * there.y() / there.z() + projector.center_y;
  const bool lit = u > 0 && v > 0 && u < projector.width - 1 &&
                   v < projector.height - 1 &&
                   std::hypot(u - projector.center_x, v - projector.center_y) <
                       projector.aperture_radius;
  const double strength = std::pow(projector.falloff_distance, 2) /
                          there.squaredNorm() * there.z() / there.norm();
  const double thrown =
      lit ? strength *
                pattern.at(static_cast<float>(u),
                           static_cast<float>(v))[static_cast<std::size_t>(channel)]
          : 0.0;
  return scene.geometry.surfaces()[0].look.color[static_cast<std::size_t>(channel)] *
         (light.ambient + thrown);
}

TEST(LitView, PatternLiesOnAWallWhereItShould)
{
  const SimulatedScene scene = wallAt(2.5);
  const SimulatedLight light = plainLight();
  const RgbImage image = wavePattern(light.projector);
  const LightPattern pattern(image, 0.0);
  const auto frame = shotOf(scene, light, image);
  const std::array<Eigen::Vector3d, 3> places{Eigen::Vector3d::Zero(),
                                              Eigen::Vector3d(-0.1, 0, 0),
                                              Eigen::Vector3d(0, -0.1, 0)};
  std::size_t lit = 0;
  for (std::size_t camera = 0; camera < places.size(); ++camera)
    for (int row = 0; row < scene.rig.height; ++row)
      for (int column = 0; column < scene.rig.width; ++column) {
        const Eigen::Vector3d ray = pixelRay(scene.rig, column, row);
        const Eigen::Vector3d point = places[camera] + ray * (2.5 / ray.z());
        const int channel = (row + column) % 3;
        const double level = levelOnWall(scene, light, pattern, point, channel);
        const int shot = valueAt(frame->images[camera], column, row, channel);
        const double plain =
            scene.geometry.surfaces()[0].look.color[static_cast<std::size_t>(channel)] *
            light.ambient;
        if (shot > plain + 1)
          ++lit;
        // At the border of the light one of the two may be dark.
        if (level != plain || shot <= plain + 1) {
          EXPECT_NEAR(shot, std::min(level, 255.0), 0.51)
              << camera << ": " << column << ", " << row;
        }
      }
  EXPECT_GT(lit, 3 * 160 * 120 * 7 / 10);
  EXPECT_LT(lit, 3 * 160 * 120 * 9 / 10);
}

TEST(LitView, BoxThrowsItsShadowOnTheWall)
{
  SimulatedScene scene = wallAt(3.0);
  SimulatedLight light = plainLight();
  light.projector.T_reference_projector.translation() = Eigen::Vector3d(0.3, 0, 0);
  // A square of 20 cm at 1.5 m: its shadow at 3 m is twice as large, and to its left.
  scene.geometry.addRectangle(
      "board", "board", {{-0.1, 0.1, 1.5}, {0.2, 0, 0}, {0, -0.2, 0}}, {});
  const RgbImage white = flatPattern(light.projector, 255);
  const auto frame = shotOf(scene, light, white);
  const CameraImage& image = frame->image(RigCamera::Reference);
  const auto isLit = [&](double x, double y) {
    const double f = scene.rig.focal_length / 3.0;
    return valueAt(image,
                   static_cast<int>(std::lround(f * x + scene.rig.center_x)),
                   static_cast<int>(std::lround(f * y + scene.rig.center_y))) > 52;
  };
  // Rays from x = 0.3 through -0.1 and 0.1 at half the distance hit the wall at -0.5
  // and -0.1; the board occludes -0.2 to 0.2 of it for the camera.
  EXPECT_TRUE(isLit(-0.53, 0));
  EXPECT_FALSE(isLit(-0.47, 0));
  EXPECT_FALSE(isLit(-0.24, 0.17));
  EXPECT_FALSE(isLit(-0.24, -0.17));
  EXPECT_TRUE(isLit(-0.24, 0.24));
  EXPECT_TRUE(isLit(-0.24, -0.24));
  EXPECT_TRUE(isLit(0.24, 0));
  EXPECT_GT(valueAt(image, 80, 60),
            200); // the board itself is half as far from the light
}

TEST(LitView, ASheetIsNotLitFromBehind)
{
  SimulatedScene scene = wallAt(3.0);
  SimulatedLight light = plainLight();
  light.projector.T_reference_projector =
      Eigen::Translation3d(0, 0, 5.0) *
      Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY());
  const auto frame = shotOf(scene, light, flatPattern(light.projector, 255));
  for (const CameraImage& image : frame->images)
    EXPECT_EQ(*std::max_element(image.values.begin(), image.values.end()), 100);
}

TEST(LitView, CastsWhatCastViewCasts)
{
  SimulatedScene scene = smallScene("office", 160);
  for (const SimulatedScene& one :
       {scene, SimulatedScene{"clutter", clutter(3), smallRig(120), {}, scene.views}}) {
    const CameraRays rays = raysOf(one.rig)[0];
    const Eigen::Isometry3d& pose = one.views[3];
    const PinholeScene pinhole(one.geometry, one.rig, pose);
    const SurfaceImage image = castView(one.geometry, one.rig, pose);
    for (int row = 0; row < one.rig.height; ++row)
      for (int column = 0; column < one.rig.width; ++column) {
        const auto hit = pinhole.hit(rays.ray(column, row));
        EXPECT_EQ(hit.surface,
                  image.surface[static_cast<std::size_t>(row * image.width + column)]);
      }
  }
}

TEST(LitView, PlacesAreSeenWhereNothingIsBefore)
{
  const SceneGeometry scene = clutter(5);
  const TrinocularRig rig = smallRig(120);
  const Eigen::Isometry3d pose(Eigen::Translation3d(0.4, -0.3, -1.0));
  const PinholeScene pinhole(scene, rig, pose);
  Random random(9);
  int seen = 0;
  for (int i = 0; i < 4000; ++i) {
    const double column = random.uniform(-0.5, rig.width - 0.5);
    const double row = random.uniform(-0.5, rig.height - 0.5);
    const Eigen::Vector3d ray((column - rig.center_x) / rig.focal_length,
                              (row - rig.center_y) / rig.focal_length,
                              1.0);
    const PinholeScene::Hit hit = pinhole.hit(ray);
    const double depth = random.uniform(0.5, 6.0);
    EXPECT_EQ(pinhole.sees(depth * ray), depth < hit.depth + 1e-5);
    if (hit.surface >= 0) {
      EXPECT_TRUE(pinhole.sees(hit.depth * ray));
      ++seen;
    }
  }
  EXPECT_GT(seen, 100);
}

TEST(LitView, EmptySceneIsBlack)
{
  SimulatedScene scene = wallAt(-2.0);
  const auto frame =
      shotOf(scene, plainLight(), flatPattern(plainLight().projector, 255));
  for (const CameraImage& image : frame->images) {
    ASSERT_EQ(image.values.size(), 3u * 160u * 120u);
    EXPECT_EQ(*std::max_element(image.values.begin(), image.values.end()), 0);
  }
}

TEST(LitView, ProjectorThatSeesNothingLightsNothing)
{
  SimulatedLight light = plainLight();
  light.projector.T_reference_projector.linear() =
      Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const auto frame = shotOf(wallAt(2.0), light, flatPattern(light.projector, 255));
  EXPECT_EQ(valueAt(frame->images[0], 80, 60, 0), 50);
  light = plainLight();
  light.projector.aperture_radius = 0.0;
  EXPECT_EQ(shotOf(wallAt(2.0), light, flatPattern(light.projector, 255))->images[0],
            frame->images[0]);
}

TEST(LitView, VignettingIsTheFourthPowerOfTheCosine)
{
  SimulatedLight light = plainLight();
  light.vignetting = true;
  light.exposure = 2.0;
  light.projector.power = 0.0;
  const SimulatedScene scene = wallAt(2.0);
  const auto frame = shotOf(scene, light, flatPattern(light.projector, 255));
  for (const auto& [column, row] : {std::pair{0, 0}, {80, 60}, {159, 30}})
    EXPECT_NEAR(valueAt(frame->images[0], column, row, 2),
                200.0 * std::pow(pixelRay(scene.rig, column, row).z(), 4),
                0.51);
}

TEST(RigSimulation, CamerasThatTheRigOfTheSceneHasNotAreRefused)
{
  const SimulatedScene scene = wallAt(2.0);
  const auto refused = [&](const std::function<void(RigCalibration&)>& spoil) {
    RigCalibration calibration = calibrationOf(scene.rig);
    EXPECT_NO_THROW(RigSimulation(scene, {}, plainLight(), raysOf(calibration)));
    spoil(calibration);
    EXPECT_THROW(RigSimulation(scene, {}, plainLight(), raysOf(calibration)),
                 BadArgumentException);
  };
  refused([](RigCalibration& cameras) { cameras.width = 80; });
  refused([](RigCalibration& cameras) {
    cameras.camera(RigCamera::Vertical).is_there = false;
  });
  refused([](RigCalibration& cameras) {
    cameras.camera(RigCamera::Reference).T_reference_camera.translation().x() = 0.1;
  });
  refused([](RigCalibration& cameras) {
    cameras.camera(RigCamera::Horizontal).distortion[3] = std::nan("");
  });
}

TEST(LightPattern, BlurKeepsLightAndSpreadsALine)
{
  RgbImage image = flatPattern(plainLight().projector, 0);
  for (int row = 0; row < image.height; ++row)
    image.at(100, row)[1] = 255;
  const LightPattern sharp(image, 0.0);
  const LightPattern blurred(image, 1.5);
  EXPECT_FLOAT_EQ(sharp.at(100, 50)[1], 1.0f);
  EXPECT_NEAR(sharp.at(100.25f, 50)[1], 0.75, 1e-5);
  double sum = 0, squares = 0;
  for (int column = 80; column < 120; ++column) {
    const double light = blurred.at(static_cast<float>(column), 50.5f)[1];
    sum += light;
    squares += light * (column - 100) * (column - 100);
    EXPECT_EQ(blurred.at(static_cast<float>(column), 50.5f)[0], 0.0f);
  }
  EXPECT_NEAR(sum, 1.0, 1e-3);
  EXPECT_NEAR(std::sqrt(squares), 1.5, 0.05);
  EXPECT_NEAR(LightPattern(flatPattern(plainLight().projector, 200), 2.0).at(0, 0)[2],
              200.0 / 255.0,
              1e-4); // its border is not darker
}

} // namespace
} // namespace pcl::acmap::test
