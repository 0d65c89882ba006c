#include "lit_scenes.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/simulation/ray_casting.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/simulated_truth.h>
#include <pcl/simulation/surface_color.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

/** Surface and position seen at a pixel. */
struct Seen {
  std::int32_t surface;
  Eigen::Vector3d point; // in the scene frame
};

Seen
seenAt(const SimulatedScene& scene,
       const SurfaceImage& image,
       const Eigen::Isometry3d& pose,
       int column,
       int row)
{
  const auto i = static_cast<std::size_t>(row * image.width + column);
  return {image.surface[i],
          pose * (image.distance[i] * pixelRay(scene.rig, column, row))};
}

TEST(SimulatedTruth, DisparitiesAreThoseOfBothCasts)
{
  SimulatedScene scene = wallAt(3.0);
  scene.geometry.addBox("box", {-0.4, -0.4, 1.2}, {0.4, 0.3, 1.6}, {});
  scene.geometry.addCylinder("column", {{0.7, 1, 2}, {0, -2, 0.1}, 0.1}, {}, true);
  scene.views.push_back(Eigen::Isometry3d(Eigen::Translation3d(0.1, 0.05, -0.1)));
  scene.views[1].rotate(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()));
  const TrinocularRig& rig = scene.rig;
  const SimulatedTruth truth = truthOf(scene, 1);
  const SurfaceImage image = castView(scene.geometry, rig, scene.views[1]);
  const Eigen::Isometry3d left =
      scene.views[1] * Eigen::Translation3d(rig.baseline_horizontal, 0, 0);
  const Eigen::Isometry3d top =
      scene.views[1] * Eigen::Translation3d(0, rig.baseline_vertical, 0);
  EXPECT_EQ(truth.surfaces, image.surface);
  int agree = 0, seen = 0, hidden = 0;
  for (int row = 0; row < rig.height; ++row)
    for (int column = 0; column < rig.width; ++column) {
      const auto i = static_cast<std::size_t>(row * rig.width + column);
      ASSERT_GE(image.surface[i], 0);
      const double z = image.distance[i] * pixelRay(rig, column, row).z();
      EXPECT_FLOAT_EQ(truth.horizontal.at(column, row), rig.focal_length * 0.1 / z);
      EXPECT_FLOAT_EQ(truth.vertical.at(column, row), rig.focal_length * 0.1 / z);
      // A rig with a pixel exactly at this position sees the surface there, or an
      // occluding one.
      for (const auto& [pose, disparity, shift, flag] :
           {std::tuple{left,
                       truth.horizontal.at(column, row),
                       Eigen::Vector2d(1, 0),
                       SimulatedTruth::in_horizontal},
            std::tuple{top,
                       truth.vertical.at(column, row),
                       Eigen::Vector2d(0, 1),
                       SimulatedTruth::in_vertical}}) {
        const Eigen::Vector2d at = Eigen::Vector2d(column, row) + disparity * shift;
        const bool inside = at.x() <= rig.width - 0.5 && at.y() <= rig.height - 0.5;
        const bool flagged = (truth.visible[i] & flag) != 0;
        if (!inside || (row + column) % 7 != 0) {
          EXPECT_LE(flagged, inside);
          continue;
        }
        TrinocularRig moved = rig;
        moved.width = moved.height = 1;
        moved.center_x = rig.center_x - at.x();
        moved.center_y = rig.center_y - at.y();
        const SurfaceImage one = castView(scene.geometry, moved, pose);
        const Seen there = seenAt({"", {}, moved, {}, {}}, one, pose, 0, 0);
        const Seen here = seenAt(scene, image, scene.views[1], column, row);
        const bool same =
            there.surface == here.surface && (there.point - here.point).norm() < 1e-4;
        agree += same == flagged ? 1 : 0;
        ++seen;
        hidden += same ? 0 : 1;
        if (same) {
          const auto index = static_cast<std::size_t>(here.surface);
          const auto& surface = scene.geometry.surfaces()[index];
          EXPECT_EQ(surfaceColor(surface, index, there.point)[0],
                    surfaceColor(surface, index, here.point)[0]);
        }
      }
    }
  EXPECT_GT(seen, 2000);
  EXPECT_GT(hidden, 50);
  EXPECT_GE(agree, seen - seen / 1000); // pixels on an edge can differ
}

TEST(SimulatedTruth, TellsWhereLightFalls)
{
  const SimulatedScene scene = smallScene("corridor", 160);
  SimulatedLight light = plainLight();
  const SimulatedTruth truth = truthOf(scene, 5, light.projector);
  const SimulatedRigGrabber grabber(scene, {flatPattern(light.projector, 255)}, light);
  const auto frames = grabber.observe(5);
  const auto& off = frames[0]->images[0].values;
  const auto& on = frames[1]->images[0].values;
  int lit = 0;
  for (std::size_t i = 0; i < truth.visible.size(); ++i) {
    const bool brighter = on[3 * i] > off[3 * i] || on[3 * i + 2] > off[3 * i + 2];
    if (brighter) {
      EXPECT_TRUE(truth.visible[i] & SimulatedTruth::in_light) << i;
    }
    lit += truth.visible[i] & SimulatedTruth::in_light ? 1 : 0;
  }
  EXPECT_GT(lit, 160 * 120 / 3);
  EXPECT_LT(lit, 160 * 120 * 9 / 10);
}

TEST(SimulatedTruth, NothingSeenIsNaN)
{
  SimulatedScene scene = wallAt(-2.0);
  scene.rig.baseline_vertical = 0;
  const SimulatedTruth truth = truthOf(scene, 0);
  EXPECT_EQ(truth.vertical.values.size(), 0u);
  for (std::size_t i = 0; i < truth.visible.size(); ++i) {
    EXPECT_TRUE(std::isnan(truth.horizontal.values[i]));
    EXPECT_EQ(truth.visible[i], 0);
    EXPECT_EQ(truth.surfaces[i], -1);
  }
}

TEST(SimulatedTruth, NonsenseIsRefused)
{
  EXPECT_THROW(truthOf(wallAt(2), 1), BadArgumentException);
  SimulatedScene scene = wallAt(2);
  scene.rig.focal_length = -1;
  EXPECT_THROW(truthOf(scene, 0), BadArgumentException);
  SimulatedProjector projector;
  projector.width = 0;
  EXPECT_THROW(truthOf(wallAt(2), 0, projector), BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
