#include "scenes_with_up.h"
#include "test_data.h"

#include <pcl/core/noise_scale.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/random.h>
#include <pcl/core/up_evidence.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector3d;

UpEvidence
upOf(const SceneWithUp& scene, const Eigen::Matrix3d& turn, unsigned threads = 0)
{
  std::vector<Eigen::Vector3f> points;
  for (const Vector3d& point : scene.points)
    points.emplace_back((turn * point).cast<float>());
  const PointView view(points.data(), sizeof(Eigen::Vector3f), points.size());
  const NoiseScale scale = measureNoiseScale(view, {}, threads);
  return findUp(view, scale.spacing, scale.sigma, std::nullopt, threads);
}

/** What is found is right for each axis of the frame; all else is assumed, and told. */
TEST(UpEvidence, isNeverWrongWithoutASaying)
{
  std::size_t found = 0, asked = 0;
  for (std::uint64_t seed : {1, 2})
    for (const SceneWithUp& scene : scenesWithUp(seed))
      for (const Eigen::Matrix3d& turn : turnsToAxes()) {
        const UpEvidence up = upOf(scene, turn);
        ++asked;
        found += up.isKnown();
        EXPECT_TRUE(!up.isKnown() || up.value.dot(turn * scene.up) > 0.99)
            << scene.name << ": " << up.value.transpose() << ", " << up.evidence;
        EXPECT_EQ(up.confidence > 0, up.isKnown());
        EXPECT_FALSE(up.evidence.empty());
      }
  EXPECT_GT(5 * found, asked);
}

TEST(UpEvidence, isFoundInARoomWithoutCeilingInEachFrame)
{
  for (const Eigen::Matrix3d& turn : turnsToAxes()) {
    const SceneWithUp room = turnedRoomWithoutCeiling(3);
    const UpEvidence up = upOf(room, turn);
    EXPECT_EQ(up.outcome, UpOutcome::Found) << up.evidence;
    EXPECT_GT(up.value.dot(turn * room.up), 0.999);
  }
}

TEST(UpEvidence, doesNotDependOnThreads)
{
  const SceneWithUp room = turnedRoomWithoutCeiling(4);
  const UpEvidence one = upOf(room, Eigen::Matrix3d::Identity(), 1),
                   many = upOf(room, Eigen::Matrix3d::Identity(), 4);
  EXPECT_EQ(one.value, many.value);
  EXPECT_EQ(one.confidence, many.confidence);
  EXPECT_EQ(one.evidence, many.evidence);
}

TEST(UpEvidence, ofACameraIsAssumed)
{
  SceneWithUp view;
  for (int row = 0; row < 60; ++row)
    for (int column = 0; column < 80; ++column)
      view.points.emplace_back(0.02 * (column - 40), 0.02 * (row - 30), 2);
  const UpEvidence up = upOf(view, Eigen::Matrix3d::Identity());
  EXPECT_EQ(up.outcome, UpOutcome::Assumed);
  EXPECT_EQ(up.value, -Vector3d::UnitY());
}

/** Points of a rectangle, with noise in each direction. */
void
addRectangle(const Vector3d& corner,
             const Vector3d& one,
             const Vector3d& other,
             SceneWithUp& scene)
{
  constexpr double step = 0.1;
  Random random(scene.points.size() + 1);
  for (double a = 0; a < one.norm(); a += step)
    for (double b = 0; b < other.norm(); b += step)
      scene.points.push_back(
          corner + a * one.normalized() + b * other.normalized() +
          0.003 * Vector3d(random.normal(), random.normal(), random.normal()));
}

TEST(UpEvidence, ofAWallAloneIsAssumed)
{
  SceneWithUp facade;
  addRectangle({-8, 0, 0}, {16, 0, 0}, {0, 0, 5}, facade);
  addRectangle({-8, 0.2, 5}, {16, 0, 0}, {0, 0, 6}, facade);
  const UpEvidence up = upOf(facade, Eigen::Matrix3d::Identity());
  EXPECT_EQ(up.outcome, UpOutcome::Assumed);
  EXPECT_EQ(up.value, Vector3d::UnitZ());
}

/** Steps stand on the wall beside them as things stand on a floor. */
TEST(UpEvidence, isNotThroughTheWallBesideSteps)
{
  for (const double width : {1.0, 1.5}) {
    SceneWithUp stairs;
    constexpr double tread = 0.29, rise = 0.17;
    constexpr int steps = 14;
    for (int k = 0; k < steps; ++k) {
      addRectangle({0, k * tread, k * rise}, {width, 0, 0}, {0, tread, 0}, stairs);
      addRectangle({0, k * tread, (k - 1) * rise}, {width, 0, 0}, {0, 0, rise}, stairs);
    }
    addRectangle(
        {width, 0, -rise}, {0, steps * tread, 0}, {0, 0, steps * rise + 2.4}, stairs);
    const UpEvidence up = upOf(stairs, Eigen::Matrix3d::Identity());
    EXPECT_EQ(up.outcome, UpOutcome::Assumed) << up.evidence;
    EXPECT_EQ(up.value, Vector3d::UnitZ());
  }
}

/** Above the origin of a site's frame, all of a building is within the view of a camera. */
TEST(UpEvidence, ofABuildingAboveTheOriginIsNotThatOfACamera)
{
  SceneWithUp floor;
  addRectangle({2, 3, 50}, {9, 0, 0}, {0, 7, 0}, floor);
  addRectangle({2, 3, 52.6}, {9, 0, 0}, {0, 7, 0}, floor);
  addRectangle({2, 3, 50}, {9, 0, 0}, {0, 0, 2.6}, floor);
  EXPECT_EQ(upOf(floor, Eigen::Matrix3d::Identity()).value, Vector3d::UnitZ());
}

/** The end of a hall that a scanner faces is no floor, though all else is before it. */
TEST(UpEvidence, isNotAlongWhatASensorFaces)
{
  SceneWithUp hall;
  addRectangle({3, -6, -1.5}, {20, 0, 0}, {0, 12, 0}, hall);
  addRectangle({3, -6, -1.5}, {20, 0, 0}, {0, 0, 4}, hall);
  addRectangle({23, -6, -1.5}, {0, 12, 0}, {0, 0, 8}, hall);
  std::vector<Eigen::Vector3f> points;
  for (const Vector3d& point : hall.points)
    points.push_back(point.cast<float>());
  const PointView view(points.data(), sizeof(Eigen::Vector3f), points.size());
  SensorEvidence sensor;
  sensor.outcome = SensorOutcome::Proved;
  const NoiseScale scale = measureNoiseScale(view, {});
  const UpEvidence up =
      findUp(view, scale.spacing, scale.sigma, std::nullopt, 0, sensor);
  EXPECT_LT(std::abs(up.value.x()), 0.5) << up.evidence;
}

/** A phone's room with y up, and a facade with its pavement. */
TEST(UpEvidence, isThatOfFilesOfOthers)
{
  if (!hasTestData("H_field/clouds/room_y_up.ply"))
    GTEST_SKIP() << "H_field is not in the folder that ACMAP_TEST_DATA names";
  const auto upOfFile = [](const std::string& name) {
    const PointCloudFile file =
        loadPointCloud(testDataPath("H_field/clouds/" + name).string());
    const NoiseScale scale = measureNoiseScale(file.points(), {});
    return findUp(file.points(), scale.spacing, scale.sigma, file.usual_up);
  };
  const UpEvidence room = upOfFile("room_y_up.ply");
  EXPECT_EQ(room.outcome, UpOutcome::Found);
  EXPECT_GT(room.value.y(), 0.999);
  EXPECT_GT(upOfFile("room_y_up.obj").value.y(), 0.999);
  EXPECT_GT(upOfFile("facade_z_up.ply").value.z(), 0.999);
}

} // namespace
} // namespace pcl::acmap::test
