#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/point_types.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_sequence.h>

#include <gmock/gmock.h>

#include <chrono>
#include <cstdio>
#include <filesystem>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Eigen::Isometry3d
poseAt(double x)
{
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation().x() = x;
  return pose;
}

/** A folder with observations of four points, at x = 0, 1, ... metres. */
class Observations : public testing::Test {
protected:
  explicit Observations(std::size_t count = 3)
  {
    for (std::size_t i = 0; i < count; ++i) {
      PointCloud<PointXYZRGBSigma> points(2, 2);
      points[0].x = static_cast<float>(i);
      PCLPointCloud2 cloud;
      toPCLPointCloud2(points, cloud);
      saveObservation(
          folder_.path(observationName(i)), cloud, poseAt(static_cast<double>(i)));
    }
  }

  void
  writeTrajectory(const std::vector<double>& places) const
  {
    Trajectory trajectory;
    for (const double place : places) {
      trajectory.stamps.push_back(10 * place);
      trajectory.poses.push_back(poseAt(place));
    }
    saveTrajectory(folder_.path(trajectory_name), trajectory);
  }

  static double
  placeOf(const PosedObservation& observation)
  {
    return observation.T_map_camera.translation().x();
  }

  TemporaryFolder folder_;
};

TEST_F(Observations, HaveTheirViewpointsForPoses)
{
  const ObservationSequence sequence(folder_.path(""));
  ASSERT_EQ(sequence.size(), 3U);
  EXPECT_FALSE(sequence.hasTrajectory());
  EXPECT_EQ(placeOf(sequence.load(2)), 2);
  EXPECT_EQ(sequence.load(2).file->points()[0].x(), 2);
  EXPECT_EQ(sequence.stamp(2), 2);
}

TEST_F(Observations, HaveThePosesOfTheTrajectory)
{
  writeTrajectory({0, 1, 2.5, 7});
  const ObservationSequence sequence(folder_.path(""));
  EXPECT_THAT(sequence.remarks(), ElementsAre(HasSubstr("has 4 poses")));
  EXPECT_THAT(sequence.load(1).remarks, IsEmpty());
  const PosedObservation last = sequence.load(2);
  EXPECT_EQ(placeOf(last), 2.5);
  EXPECT_THAT(last.remarks, ElementsAre(HasSubstr("VIEWPOINT is 0.5 m")));
  EXPECT_EQ(sequence.stamp(2), 25);
}

TEST_F(Observations, AreScaledWithTheirPoses)
{
  writeTrajectory({0, 1, 2.5});
  const ObservationSequence sequence(folder_.path(""), 0.5);
  EXPECT_EQ(placeOf(sequence.load(2)), 1.25);
  EXPECT_EQ(sequence.load(2).file->points()[0].x(), 1);
}

TEST_F(Observations, AreReadOnceByAllCopies)
{
  const ObservationSequence sequence(folder_.path(""));
  const ObservationSequence posed =
      sequence.withPoses({0, 1, 2}, {{0, 1, 2}, std::vector(3, poseAt(5))});
  for (int round = 0; round < 3; ++round)
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      EXPECT_EQ(placeOf(sequence.load(i)), static_cast<double>(i));
      EXPECT_EQ(placeOf(posed.load(i)), 5);
      EXPECT_EQ(sequence.load(i).file, posed.load(i).file);
    }
  EXPECT_EQ(sequence.getNumberOfReads(), 3U);
}

TEST_F(Observations, BeyondTheCacheAreReadAgain)
{
  ObservationSequence sequence(folder_.path(""));
  sequence.setCacheSize(sequence.load(0).file->cloud.data.size());
  for (int round = 0; round < 2; ++round)
    for (std::size_t i = 0; i < sequence.size(); ++i)
      EXPECT_EQ(placeOf(sequence.load(i)), static_cast<double>(i));
  EXPECT_EQ(sequence.getNumberOfReads(), 5U) << "the first one is kept";
  sequence.setCacheSize(0);
  sequence.load(0);
  EXPECT_EQ(sequence.getNumberOfReads(), 6U);
}

TEST_F(Observations, WithPosesOfSomeAreThese)
{
  const ObservationSequence sequence(folder_.path(""));
  const ObservationSequence some =
      sequence.withPoses({0, 2}, {{3, 4}, {poseAt(8), poseAt(9)}});
  EXPECT_THAT(some.names(),
              ElementsAre("observation_0000.pcd", "observation_0002.pcd"));
  const PosedObservation last = some.load(1);
  EXPECT_EQ(placeOf(last), 9);
  EXPECT_EQ(last.file->points()[0].x(), 2);
  EXPECT_THAT(last.remarks, IsEmpty()) << "its VIEWPOINT does not count";
  EXPECT_EQ(some.stamp(1), 4);
  const Trajectory two = {{3, 4}, {poseAt(8), poseAt(9)}};
  EXPECT_THROW(sequence.withPoses({0, 3}, two), BadArgumentException);
  EXPECT_THROW(sequence.withPoses({2, 0}, two), BadArgumentException);
  EXPECT_THROW(sequence.withPoses({1, 1}, two), BadArgumentException);
  EXPECT_THROW(sequence.withPoses({0}, {}), BadArgumentException);
  EXPECT_THROW(sequence.withPoses({}, {}), BadArgumentException)
      << "who divides by its size need not ask";
}

TEST_F(Observations, HaveAFingerprintOfTheirFilesAndPoses)
{
  const std::string before = ObservationSequence(folder_.path("")).fingerprint();
  EXPECT_EQ(ObservationSequence(folder_.path("")).fingerprint(), before);
  const ObservationSequence posed =
      ObservationSequence(folder_.path(""))
          .withPoses({0, 1, 2}, {{0, 1, 2}, std::vector(3, poseAt(5))});
  EXPECT_NE(posed.fingerprint(), before);
  const std::filesystem::path first = folder_.path("observation_0000.pcd");
  std::filesystem::last_write_time(
      first, std::filesystem::last_write_time(first) + std::chrono::seconds(1));
  EXPECT_NE(ObservationSequence(folder_.path("")).fingerprint(), before);
}

TEST(ObservationsInMemory, HaveAFingerprintOfTheirBytes)
{
  const auto cloud = std::make_shared<PointCloudFile>();
  toPCLPointCloud2(PointCloud<PointXYZ>(3, 1), cloud->cloud);
  const std::string before = ObservationSequence({cloud}).fingerprint();
  const auto other = std::make_shared<PointCloudFile>(*cloud);
  EXPECT_EQ(ObservationSequence({other}).fingerprint(), before);
  other->cloud.data[1] = 7;
  EXPECT_NE(ObservationSequence({other}).fingerprint(), before);
}

TEST_F(Observations, ThatAllHaveOnePoseHaveNone)
{
  const ObservationSequence sequence(folder_.path(""));
  EXPECT_NO_THROW(sequence.requireDifferent({poseAt(0), poseAt(1)}));
  EXPECT_THROW(sequence.requireDifferent({poseAt(1), poseAt(1)}), InputFileException);
}

TEST_F(Observations, ThatCannotBeReadAreNamed)
{
  folder_.write("observation_0001.pcd", "no cloud");
  const ObservationSequence sequence(folder_.path(""));
  EXPECT_NO_THROW(sequence.load(0));
  EXPECT_THROW(sequence.load(1), InputFileException);
  EXPECT_THROW(ObservationSequence(folder_.path("nowhere")), InputFileException);
  EXPECT_THROW(ObservationSequence(std::vector<std::string>()), BadArgumentException);
}

/** A PCD of doubles with three points. */
std::string
pcdNear(const Eigen::Vector3d& place)
{
  std::string text = "VERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\n"
                     "WIDTH 3\nHEIGHT 1\nPOINTS 3\nDATA ascii\n";
  for (int i = 0; i < 3; ++i) {
    char row[100];
    std::snprintf(row,
                  sizeof row,
                  "%.4f %.4f %.4f\n",
                  place.x() + 0.001 * i,
                  place.y(),
                  place.z());
    text += row;
  }
  return text;
}

TEST(ObservationsInAGrid, AreShiftedTogether)
{
  const TemporaryFolder folder;
  const Eigen::Vector3d first(665305.663, 5648402.759, 248.695),
      second(664999.25, 5648999.5, 250);
  folder.write(observationName(0), pcdNear(first));
  folder.write(observationName(1), pcdNear(second));
  Trajectory trajectory;
  trajectory.stamps = {0, 1};
  trajectory.poses = {poseAt(0), poseAt(0.5)};
  saveTrajectory(folder.path(trajectory_name), trajectory);
  const auto expectPlaces = [&](const ObservationSequence& sequence) {
    for (std::size_t i = 0; i < 2; ++i) {
      const PosedObservation seen = sequence.load(i);
      const Eigen::Vector3d place =
          seen.T_map_camera * seen.file->points()[0].cast<double>() + sequence.shift();
      const Eigen::Vector3d expected =
          i == 0 ? first : (second + Eigen::Vector3d(0.5, 0, 0)).eval();
      EXPECT_LT((place - expected).norm(), 1e-4);
      EXPECT_LT(seen.T_map_camera.translation().norm(), 1001);
    }
  };
  const ObservationSequence sequence(folder.path(""));
  EXPECT_EQ(sequence.shift(), Eigen::Vector3d(665000, 5648000, 0));
  EXPECT_EQ(sequence.load(1).file->shift, sequence.shift()) << "that of the first file";
  EXPECT_THAT(sequence.remarks(), ElementsAre(HasSubstr("665000, 5648000, 0")));
  expectPlaces(sequence);
  const ObservationSequence stated(
      folder.path(""), 1, Eigen::Vector3d(665300, 5648400, 200));
  EXPECT_EQ(stated.shift(), Eigen::Vector3d(665300, 5648400, 200));
  expectPlaces(stated);
}

TEST(ObservationsInAGrid, MayHaveOnlyTheirPosesThere)
{
  const TemporaryFolder folder;
  folder.write(observationName(0), pcdNear({1, 2, 3}));
  folder.write(observationName(1), pcdNear({1, 2, 3}));
  Trajectory trajectory;
  trajectory.stamps = {0, 1};
  trajectory.poses = {poseAt(665305.663), poseAt(665306.125)};
  saveTrajectory(folder.path(trajectory_name), trajectory);
  const ObservationSequence sequence(folder.path(""));
  EXPECT_EQ(sequence.shift(), Eigen::Vector3d(665000, 0, 0));
  EXPECT_NEAR(sequence.pose(1).translation().x(), 306.125, 1e-4);
}

} // namespace
} // namespace pcl::acmap::test
