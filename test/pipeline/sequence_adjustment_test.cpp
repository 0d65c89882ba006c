#include "adjustment_room.h"
#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/trajectory_error.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/sequence_adjustment.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace pcl::acmap::test {
namespace {

using Poses = std::vector<Eigen::Isometry3d>;

constexpr double sigma = 0.005, turn = 0.006, length = 0.01; // metres, radians
constexpr std::size_t views = 16;

double
heightError(const Poses& poses, const Poses& truth)
{
  double largest = 0;
  for (std::size_t i = 0; i < poses.size(); ++i)
    largest = std::max(
        largest, std::abs(poses[i].translation().y() - truth[i].translation().y()));
  return largest;
}

/** The room from all poses of its path, as observations in memory. */
class SequenceAdjustmentRoom : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    for (std::size_t i = 0; i < views; ++i) {
      const auto cloud = AdjustmentRoom::view(truth_[i], sigma, i + 1);
      const auto file = std::make_shared<PointCloudFile>();
      toPCLPointCloud2(*cloud, file->cloud);
      files_.push_back(file);
    }
  }

  static void
  TearDownTestSuite()
  {
    files_.clear();
  }

  SequenceAdjustmentRoom()
  {
    adjustment_.setOdometryNoise({length, 0, turn, 0});
  }

  static Trajectory
  trajectoryOf(const Poses& poses)
  {
    Trajectory trajectory;
    for (std::size_t i = 0; i < poses.size(); ++i)
      trajectory.stamps.push_back(0.5 * static_cast<double>(i));
    trajectory.poses = poses;
    return trajectory;
  }

  static inline const Poses truth_ = AdjustmentRoom::path(views);
  static inline const Poses given_ = AdjustmentRoom::drifted(truth_, turn, length, 3);
  static inline std::vector<std::shared_ptr<const PointCloudFile>> files_;
  SequenceAdjustment adjustment_;
};

TEST_F(SequenceAdjustmentRoom, heightsOfADriftingSequenceBecomeRight)
{
  Trajectory adjusted;
  adjustment_.compute(ObservationSequence(files_, trajectoryOf(given_)), adjusted);
  EXPECT_EQ(adjusted.stamps, trajectoryOf(given_).stamps);
  EXPECT_GT(heightError(given_, truth_), 0.015);
  EXPECT_LT(heightError(adjusted.poses, truth_), 0.003);
  EXPECT_LT(absoluteTrajectoryError(adjusted.poses, truth_).unaligned,
            0.1 * absoluteTrajectoryError(given_, truth_).unaligned);
  const PlaneAdjustmentReport& report = adjustment_.getReport();
  EXPECT_EQ(report.outcome, AdjustmentOutcome::Adjusted);
  EXPECT_EQ(report.views, views);
  EXPECT_EQ(report.points, views * 320 * 240);
  EXPECT_NEAR(report.noise_factor, 1, 0.1) << "sigma of the files was not used";
  ASSERT_EQ(report.moved.size(), views);
  for (std::size_t i = 0; i < views; ++i)
    EXPECT_NEAR(report.moved[i],
                (adjusted.poses[i].translation() - given_[i].translation()).norm(),
                1e-12);
}

TEST_F(SequenceAdjustmentRoom, rightPosesAreKept)
{
  Trajectory adjusted;
  adjustment_.compute(ObservationSequence(files_, trajectoryOf(truth_)), adjusted);
  EXPECT_EQ(adjustment_.getReport().outcome, AdjustmentOutcome::Kept);
  for (std::size_t i = 0; i < views; ++i)
    EXPECT_EQ(adjusted.poses[i].matrix(), truth_[i].matrix());
}

/** Poses so far from each other that no view sees what another one does. */
Poses
farApart(Poses poses)
{
  for (std::size_t i = 0; i < poses.size(); ++i)
    poses[i].translation().x() += 100 * static_cast<double>(i);
  return poses;
}

TEST_F(SequenceAdjustmentRoom, posesBeforeARectificationAreTriedFirst)
{
  Trajectory alone, wrong, undetermined;
  adjustment_.compute(ObservationSequence(files_, trajectoryOf(given_)), alone);
  adjustment_.setPosesBefore(given_);
  adjustment_.compute(ObservationSequence(files_, trajectoryOf(farApart(given_))),
                      wrong);
  EXPECT_EQ(adjustment_.getReport().outcome, AdjustmentOutcome::Adjusted);
  adjustment_.setPosesBefore(farApart(given_));
  adjustment_.compute(ObservationSequence(files_, trajectoryOf(given_)), undetermined);
  EXPECT_EQ(adjustment_.getReport().outcome, AdjustmentOutcome::Adjusted);
  for (std::size_t i = 0; i < views; ++i) {
    EXPECT_EQ(wrong.poses[i].matrix(), alone.poses[i].matrix()) << i;
    EXPECT_EQ(undetermined.poses[i].matrix(), alone.poses[i].matrix()) << i;
  }
  adjustment_.setPosesBefore({given_.front()});
  EXPECT_THROW(
      adjustment_.compute(ObservationSequence(files_, trajectoryOf(given_)), alone),
      BadArgumentException);
}

/** Paints a view with waves in space, 5 to 40 cm long. */
void
paintWaves(const Eigen::Isometry3d& pose, PointCloud<PointXYZRGBSigma>& cloud)
{
  Random random(9);
  std::vector<Eigen::Vector4d> waves;
  for (int i = 0; i < 12; ++i) {
    Eigen::Vector3d direction(random.normal(), random.normal(), random.normal());
    direction *= 2 * M_PI / random.uniform(0.05, 0.4) / direction.norm();
    waves.emplace_back(
        direction.x(), direction.y(), direction.z(), random.uniform(0, 2 * M_PI));
  }
  for (PointXYZRGBSigma& point : cloud) {
    const Eigen::Vector3d place = pose * point.getVector3fMap().cast<double>();
    double brightness = 128;
    for (const Eigen::Vector4d& wave : waves)
      brightness += 25 * std::sin(wave.head<3>().dot(place) + wave[3]);
    point.r = point.g = point.b =
        static_cast<std::uint8_t>(std::clamp(brightness, 0.0, 255.0));
  }
}

TEST_F(SequenceAdjustmentRoom, imagesShowWhichPlacesAreSeenAgain)
{
  std::vector<std::shared_ptr<const PointCloudFile>> painted;
  for (std::size_t i = 0; i < views; ++i) {
    const auto cloud = AdjustmentRoom::view(truth_[i], sigma, i + 1);
    paintWaves(truth_[i], *cloud);
    const auto file = std::make_shared<PointCloudFile>();
    toPCLPointCloud2(*cloud, file->cloud);
    painted.push_back(file);
  }
  Trajectory adjusted;
  adjustment_.compute(ObservationSequence(painted, trajectoryOf(given_)), adjusted);
  ASSERT_TRUE(adjustment_.getRevisitReport());
  EXPECT_GT(adjustment_.getRevisitReport()->verified, 0U) << "the path is closed";
  EXPECT_EQ(adjustment_.getReport().revisits_used,
            adjustment_.getRevisitReport()->verified);
  EXPECT_LT(absoluteTrajectoryError(adjusted.poses, truth_).unaligned, 0.003);
}

TEST_F(SequenceAdjustmentRoom, withoutColoursThereAreNoRevisits)
{
  std::vector<std::shared_ptr<const PointCloudFile>> colourless;
  for (const auto& file : files_) {
    PointCloud<PointXYZ> points;
    fromPCLPointCloud2(file->cloud, points);
    const auto copy = std::make_shared<PointCloudFile>();
    toPCLPointCloud2(points, copy->cloud);
    colourless.push_back(copy);
  }
  Trajectory adjusted;
  adjustment_.compute(ObservationSequence(colourless, trajectoryOf(given_)), adjusted);
  EXPECT_FALSE(adjustment_.getRevisitReport());
  EXPECT_EQ(adjustment_.getReport().revisits_used, 0U);
}

TEST_F(SequenceAdjustmentRoom, withoutSigmaTheNoiseIsMeasured)
{
  std::vector<std::shared_ptr<const PointCloudFile>> bare;
  for (const auto& file : files_) {
    PointCloud<PointXYZ> points;
    fromPCLPointCloud2(file->cloud, points);
    const auto copy = std::make_shared<PointCloudFile>();
    toPCLPointCloud2(points, copy->cloud);
    bare.push_back(copy);
  }
  Trajectory adjusted;
  adjustment_.compute(ObservationSequence(bare, trajectoryOf(given_)), adjusted);
  EXPECT_LT(heightError(adjusted.poses, truth_), 0.003);
  EXPECT_NEAR(adjustment_.getReport().noise_factor, sigma, 0.2 * sigma) << "metres";
}

TEST_F(SequenceAdjustmentRoom, filesGiveTheSamePosesOnAnyNumberOfThreads)
{
  const TemporaryFolder folder;
  for (std::size_t i = 0; i < views; ++i)
    saveObservation(folder.path(observationName(i)), files_[i]->cloud, given_[i]);
  saveTrajectory(folder.path(trajectory_name), trajectoryOf(given_));
  const ObservationSequence sequence(folder.path(""));
  Trajectory wanted, adjusted;
  adjustment_.setNumberOfThreads(1);
  adjustment_.compute(
      ObservationSequence(files_, loadTrajectory(folder.path(trajectory_name))),
      wanted);
  adjustment_.setNumberOfThreads(4);
  adjustment_.compute(sequence, adjusted);
  for (std::size_t i = 0; i < views; ++i)
    EXPECT_EQ(adjusted.poses[i].matrix(), wanted.poses[i].matrix());

  std::ofstream(folder.path(observationName(2)), std::ios::trunc) << "no PCD";
  EXPECT_THROW(adjustment_.compute(ObservationSequence(folder.path("")), adjusted),
               InputFileException);
  EXPECT_EQ(adjusted.poses[1].matrix(), wanted.poses[1].matrix()) << "is untouched";
}

TEST_F(SequenceAdjustmentRoom, canBeCancelled)
{
  adjustment_.setProgressCallback(
      [](double done, const std::string&) { return done < 0.5; });
  Trajectory adjusted = trajectoryOf(truth_);
  EXPECT_THROW(
      adjustment_.compute(ObservationSequence(files_, trajectoryOf(given_)), adjusted),
      CancelledException);
  EXPECT_EQ(adjusted.poses[1].matrix(), truth_[1].matrix());
  EXPECT_THROW(adjustment_.setOdometryNoise({0, 0, turn, 0}), BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
