#include "cylinders/points_beside.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace pcl::acmap::test {
namespace {

using namespace cylinders;

/** Points of a room in the order of rows through it, every fourth on one of five planes,
 * and some that are not finite. */
struct BesideScene {
  std::vector<Eigen::Vector3f> points;
  RawCloud cloud;
  PointLabels owners;

  BesideScene()
  {
    Random random(11);
    for (int row = 0; row < 200; ++row)
      for (int i = 0; i < 400; ++i)
        points.emplace_back(0.01F * static_cast<float>(i),
                            0.02F * static_cast<float>(row),
                            static_cast<float>(random.uniform(0, 2)));
    for (std::size_t i = 0; i < points.size(); i += 1777)
      points[i].x() = std::numeric_limits<float>::quiet_NaN();
    cloud.points = PointView(points.data(), sizeof(Eigen::Vector3f), points.size());
    cloud.spacing = 0.02;
    cloud.sigma = 0.01;
    for (std::size_t i = 0; i < points.size(); ++i) {
      cloud.labels.push_back(i % 4 == 0 ? static_cast<std::int32_t>(i % 5) : -1);
      owners.push_back(i % 9 == 0 ? 2 : -1);
    }
  }
};

/** The points within the limits of a fit, by comparison of all. */
PointsBeside
besideByComparison(const BesideScene& scene,
                   const std::vector<std::int32_t>& replaced,
                   const Cylinder& cylinder,
                   const CylinderReach& reach)
{
  PointsBeside beside;
  const double band = 8 * scene.cloud.sigma + 2 * scene.cloud.spacing;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const Eigen::Vector3d point = scene.points[i].cast<double>();
    if (!point.allFinite() || cylinder.along(point) <= reach.low - band ||
        cylinder.along(point) >= reach.high + band ||
        std::abs(cylinder.distance(point)) >= band + 0.5 * cylinder.radius)
      continue;
    const std::int32_t label = scene.cloud.labels[i];
    const bool is_free =
        scene.owners[i] < 0 &&
        (label < 0 || std::count(replaced.begin(), replaced.end(), label) > 0);
    if (is_free)
      beside.free.push_back(static_cast<std::int32_t>(i));
    else if (label >= 0)
      beside.planes.insert(label);
    const bool is_on = std::abs(cylinder.distance(point)) <= 2 * scene.cloud.sigma;
    beside.on += is_on ? 1 : 0;
    beside.free_on += is_on && is_free ? 1 : 0;
  }
  return beside;
}

TEST(PointsBeside, areThoseOfBruteForce)
{
  const BesideScene scene;
  const SourceBlocks blocks(scene.cloud);
  Random random(12);
  for (int k = 0; k < 40; ++k) {
    Cylinder cylinder;
    const double x = random.uniform(-1, 5), y = random.uniform(-1, 5);
    cylinder.point = {x, y, random.uniform(-1, 3)};
    const double a = random.normal(), b = random.normal();
    cylinder.axis = Eigen::Vector3d(a, b, random.normal()).normalized();
    cylinder.radius = random.uniform(0.02, 0.6);
    CylinderReach reach;
    reach.low = random.uniform(-1, 0);
    reach.high = random.uniform(0, 1);
    reach.arc_length = 7; // all around
    const PointsBeside found = blocks.beside(scene.owners, {1, 3}, cylinder, reach);
    const PointsBeside expected = besideByComparison(scene, {1, 3}, cylinder, reach);
    EXPECT_EQ(found.free, expected.free);
    EXPECT_EQ(found.planes, expected.planes);
    EXPECT_EQ(found.on, expected.on);
    EXPECT_EQ(found.free_on, expected.free_on);
  }
}

} // namespace
} // namespace pcl::acmap::test
