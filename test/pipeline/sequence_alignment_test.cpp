#include "office_views.h"
#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/compact_mapping.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_list.h>
#include <pcl/pipeline/sequence_alignment.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

namespace pcl::acmap::test {
namespace {

/** The views of an office, and the same views in a map of another frame. */
class TwoSessions : public OfficeViews {
protected:
  static Eigen::Isometry3d
  motion()
  {
    Eigen::Isometry3d T_first_second = Eigen::Isometry3d::Identity();
    T_first_second.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY()));
    T_first_second.translation() = Eigen::Vector3d(3, 0, -2);
    return T_first_second;
  }

  static ObservationSequence
  first()
  {
    return ObservationSequence(clouds_, trajectory_);
  }

  static ObservationSequence
  second()
  {
    Trajectory moved = trajectory_;
    for (Eigen::Isometry3d& pose : moved.poses)
      pose = motion().inverse() * pose;
    return ObservationSequence(clouds_, moved);
  }

  static void
  expectMotion(const Eigen::Isometry3d& found, double distance, double angle)
  {
    const Eigen::Isometry3d error = motion().inverse() * found;
    EXPECT_LT(error.translation().norm(), distance);
    EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), angle);
  }
};

TEST_F(TwoSessions, AreAlignedAtThePlacesThatBothHaveSeen)
{
  SequenceAlignment alignment;
  EXPECT_THROW(alignment.align(second()), InitFailedException);
  alignment.setInputTarget(first());
  for (const MotionModel model : {MotionModel::Planar, MotionModel::Rigid}) {
    alignment.setMotionModel(model);
    const auto found = alignment.align(second());
    ASSERT_TRUE(found);
    expectMotion(*found, 0.01, 0.003);
    EXPECT_GE(alignment.getReport().places, 2U) << "one view has few keypoints";
    EXPECT_GE(alignment.getReport().agreeing, 2U);
    EXPECT_LE(alignment.getReport().agreeing, alignment.getReport().places);
    if (model == MotionModel::Planar) {
      EXPECT_EQ(found->translation().y(), 0);
      EXPECT_EQ(found->linear().col(1), Eigen::Vector3d::UnitY());
    }
  }
}

TEST_F(TwoSessions, WithoutACommonPlaceAreNotAligned)
{
  const auto blank = std::make_shared<PointCloudFile>(*clouds_[0]);
  std::fill(blank->cloud.data.begin(), blank->cloud.data.end(), 0);
  SequenceAlignment alignment;
  alignment.setInputTarget(first());
  EXPECT_FALSE(alignment.align(ObservationSequence({blank})));
  const auto unorganized = std::make_shared<PointCloudFile>(*clouds_[0]);
  unorganized->cloud.width *= unorganized->cloud.height;
  unorganized->cloud.height = 1;
  EXPECT_THROW(alignment.align(ObservationSequence({unorganized})), InputFileException);
}

TEST_F(TwoSessions, FollowEachOther)
{
  const ObservationSequence joined = first().followedBy(second());
  ASSERT_EQ(joined.size(), 2 * views);
  for (std::size_t i = 0; i < joined.size(); ++i) {
    const ObservationSequence of = i < views ? first() : second();
    EXPECT_EQ(joined.load(i).file, clouds_[i % views]);
    EXPECT_EQ(joined.pose(i).matrix(), of.pose(i % views).matrix());
    if (i > 0) {
      EXPECT_GT(joined.stamp(i), joined.stamp(i - 1));
    }
  }
}

TEST_F(TwoSessions, BecomeOneMap)
{
  for (const bool arrives : {false, true}) {
    CompactMapping mapping;
    mapping.setEarlierObservations(first());
    if (arrives)
      mapping.start();
    for (std::size_t i = 0; i < views; ++i)
      mapping.addObservation(clouds_[i], motion().inverse() * trajectory_.poses[i]);
    CompactMap map;
    mapping.compute(map);
    ASSERT_EQ(map.trajectory.poses.size(), 2 * views);
    EXPECT_EQ(mapping.getMappedSequence().size(), 2 * views);
    ASSERT_TRUE(mapping.getReport().extension);
    for (std::size_t i = 0; i < views; ++i)
      EXPECT_LT((map.trajectory.poses[i].translation() -
                 map.trajectory.poses[i + views].translation())
                    .norm(),
                0.03);
  }
}

TEST_F(TwoSessions, AreFoundByTheListOfTheirFiles)
{
  const TemporaryFolder folder;
  const std::string map = folder.path("map"), list = map + "/stages/observations.txt";
  std::filesystem::create_directories(map + "/inside");
  std::filesystem::create_directories(map + "/stages");
  EXPECT_THROW(openMappedObservations(map), InputFileException) << "no list";
  saveObservation(map + "/inside/a b.pcd", clouds_[0]->cloud, trajectory_.poses[0]);
  saveObservation(folder.path("outside.pcd"), clouds_[1]->cloud, trajectory_.poses[1]);
  Trajectory two = trajectory_;
  two.stamps.resize(2);
  two.poses.resize(2);
  saveObservationList(list,
                      map,
                      ObservationSequence(std::vector<std::string>{
                          map + "/inside/a b.pcd", folder.path("outside.pcd")}));
  EXPECT_THROW(openMappedObservations(map), InputFileException) << "no trajectory";
  saveTrajectory(map + "/trajectory.txt", two);
  // a map may be moved together with what is in it
  std::filesystem::rename(map, folder.path("moved"));
  const ObservationSequence opened = openMappedObservations(folder.path("moved"));
  ASSERT_EQ(opened.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(opened.load(i).file->points().size(), clouds_[i]->points().size());
    EXPECT_TRUE(opened.pose(i).isApprox(two.poses[i], 1e-9));
  }
  saveTrajectory(folder.path("moved/trajectory.txt"), trajectory_);
  EXPECT_THROW(openMappedObservations(folder.path("moved")), InputFileException)
      << "another number of poses";
  saveTrajectory(folder.path("moved/trajectory.txt"), two);
  std::filesystem::remove(folder.path("outside.pcd"));
  EXPECT_THROW(openMappedObservations(folder.path("moved")), InputFileException);
}

} // namespace
} // namespace pcl::acmap::test
