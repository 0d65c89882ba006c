#include "scenes_with_up.h"
#include "test_data.h"

#include <pcl/core/noise_scale.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/up_evidence.h>

#include <gtest/gtest.h>

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
  EXPECT_GT(4 * found, asked);
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
