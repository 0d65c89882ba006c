#include "small_scenes.h"

#include <pcl/simulation/simulated_observation.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

TEST(MergedObservations, AreTheObservationsInTheMap)
{
  const SimulatedScene scene = smallScene("l_corridor");
  constexpr std::size_t views = 4;
  const MergedObservations merged = mergeObservations(scene, views, 5);
  std::size_t next = 0;
  for (std::size_t view = 0; view < views; ++view)
    for (const ObservationPixel& pixel : observe(scene, view, 5).pixels) {
      if (!std::isfinite(pixel.x))
        continue;
      ASSERT_LT(next, merged.points.size());
      const Eigen::Vector3d point(pixel.x, pixel.y, pixel.z);
      const Eigen::Vector3d in_map = merged.trajectory.poses[view] * point;
      EXPECT_LT((merged.points[next].cast<double>() - in_map).norm(), 1e-5);
      EXPECT_EQ(merged.view[next], static_cast<int>(view));
      EXPECT_EQ(merged.label[next], pixel.label);
      EXPECT_EQ(merged.rgb[next], pixel.rgb);
      ++next;
    }
  EXPECT_EQ(next, merged.points.size());
  EXPECT_EQ(next, views * scene.sensor.points);
}

TEST(MergedObservations, LieOnThePlanesOfTheMap)
{
  SimulatedScene scene = smallScene("office", 40);
  scene.sensor.min_noise = scene.sensor.max_noise = 0.0;
  const MergedObservations merged = mergeObservations(scene, 0, 1);
  EXPECT_EQ(merged.trajectory.poses.size(), scene.views.size());
  for (std::size_t i = 0; i < merged.points.size(); ++i) {
    if (merged.label[i] == 0)
      continue;
    const TruthPlane& plane = merged.planes[merged.label[i] - 1];
    const Eigen::Vector3d point = merged.points[i].cast<double>();
    EXPECT_LT(std::abs(plane.coefficients.head<3>().dot(point) + plane.coefficients[3]),
              3e-6);
    const Eigen::Vector3d sensor =
        merged.trajectory.poses[static_cast<std::size_t>(merged.view[i])].translation();
    EXPECT_GT(plane.coefficients.head<3>().dot(sensor) + plane.coefficients[3], 0.0);
  }
}

TEST(MergedObservations, FirstCameraIsTheMap)
{
  const SimulatedScene scene = smallScene("corridor");
  const Trajectory trajectory = trajectoryOf(scene, 106);
  EXPECT_TRUE(trajectory.poses[0].matrix().isIdentity(0));
  EXPECT_EQ(trajectory.stamps[105], 105.0);
  const Eigen::Isometry3d last = scene.views[0].inverse() * scene.views[105];
  EXPECT_TRUE(trajectory.poses[105].isApprox(last, 1e-12));
  EXPECT_THROW(trajectoryOf(scene, 107), BadArgumentException);
  EXPECT_THROW(trajectoryOf(scene, 0), BadArgumentException);
  EXPECT_THROW(mergeObservations(scene, 107, 1), BadArgumentException);
}

TEST(MergedObservations, ProgressIsToldAndCanCancel)
{
  const SimulatedScene scene = smallScene("loop", 40);
  double last = 0;
  mergeObservations(scene, 5, 1, [&](double fraction, const std::string&) {
    EXPECT_GT(fraction, last);
    last = fraction;
    return true;
  });
  EXPECT_EQ(last, 1.0);
  const auto stop = [](double, const std::string&) { return false; };
  EXPECT_THROW(mergeObservations(scene, 5, 1, stop), CancelledException);
}

TEST(MergedObservations, AreACloud)
{
  const SimulatedScene scene = smallScene("office", 40);
  const MergedObservations merged = mergeObservations(scene, 2, 1);
  const PCLPointCloud2 cloud = cloudOf(merged);
  EXPECT_EQ(cloud.width, merged.points.size());
  EXPECT_EQ(cloud.height, 1u);
  EXPECT_EQ(cloud.is_dense, 1);
  std::string names;
  for (const PCLPointField& field : cloud.fields)
    names += field.name + " ";
  EXPECT_EQ(names, "x y z rgb view label ");
  const std::size_t last = merged.points.size() - 1;
  float x = 0;
  std::int32_t view = 0;
  std::memcpy(&x, &cloud.data[last * cloud.point_step], sizeof(x));
  std::memcpy(&view,
              &cloud.data[last * cloud.point_step + cloud.fields[4].offset],
              sizeof(view));
  EXPECT_EQ(x, merged.points[last].x());
  EXPECT_EQ(view, 1);
}

} // namespace
} // namespace pcl::acmap::test
