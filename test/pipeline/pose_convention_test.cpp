#include "office_views.h"
#include "test_data.h"

#include <pcl/conversions.h>
#include <pcl/core/exceptions.h>
#include <pcl/pipeline/pose_convention_check.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <gmock/gmock.h>

#include <limits>
#include <numeric>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using Poses = std::vector<Eigen::Isometry3d>;

constexpr std::size_t half_drive = 20;

bool
areAlike(const PoseReading& a, const PoseReading& b)
{
  return a.convention == b.convention && a.scale == b.scale;
}

/** The matrix that stands in a file of that convention and unit. */
Eigen::Isometry3d
recordedAs(const PoseReading& reading, const Eigen::Isometry3d& T_world_camera)
{
  Eigen::Matrix4d matrix = T_world_camera.matrix();
  if (reading.convention == PoseConvention::OpenGl ||
      reading.convention == PoseConvention::OpenGlWorldToCamera)
    matrix.middleCols(1, 2) *= -1;
  if (reading.convention == PoseConvention::WorldToCamera ||
      reading.convention == PoseConvention::OpenGlWorldToCamera)
    matrix = matrix.inverse().eval();
  if (reading.convention == PoseConvention::TransposedRotation)
    matrix.topLeftCorner<3, 3>().transposeInPlace();
  matrix.topRightCorner<3, 1>() /= reading.scale;
  return Eigen::Isometry3d(matrix);
}

std::vector<PoseReading>
allReadings()
{
  std::vector<PoseReading> readings;
  for (const double scale : {1.0, 0.001})
    for (std::size_t i = 0; i < pose_convention_names.size(); ++i)
      readings.push_back({static_cast<PoseConvention>(i), scale});
  return readings;
}

/** Views of a robot on its way through a corridor with a corner. */
class DriveViews : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    SimulatedScene scene = standardScene("l_corridor_drive");
    makeSmall(scene, 2);
    const Trajectory whole = trajectoryOf(scene, 2 * half_drive);
    for (std::size_t i = 0; i < 2 * half_drive; i += 2) {
      const auto file = std::make_shared<PointCloudFile>();
      file->cloud = cloudOf(observe(scene, i, 1));
      clouds_.push_back(file);
      trajectory_.stamps.push_back(static_cast<double>(i));
      trajectory_.poses.push_back(whole.poses[i]);
    }
  }

  static void
  TearDownTestSuite()
  {
    clouds_.clear();
    trajectory_ = Trajectory();
  }

  static ObservationSequence
  recorded(const PoseReading& reading)
  {
    Trajectory trajectory = trajectory_;
    for (Eigen::Isometry3d& pose : trajectory.poses)
      pose = recordedAs(reading, pose);
    return ObservationSequence(clouds_, trajectory);
  }

  static inline Trajectory trajectory_;
  static inline std::vector<std::shared_ptr<const PointCloudFile>> clouds_;
};

TEST(PoseConventions, AreReadAsTheyWereWritten)
{
  Eigen::Isometry3d pose(
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -3).normalized()));
  pose.translation() << 1, -2, 3;
  for (const PoseReading& reading : allReadings())
    EXPECT_TRUE(readPose(recordedAs(reading, pose), reading).isApprox(pose, 1e-12))
        << textOf(reading);
}

TEST_F(DriveViews, AgreeWithTheirPoses)
{
  PoseConventionCheck check;
  const ObservationSequence posed = check.compute(recorded({}));
  EXPECT_EQ(check.getReport().verdict, PoseVerdict::Agreeing);
  EXPECT_THAT(check.getReport().equivalents, IsEmpty());
  for (std::size_t i = 0; i < posed.size(); ++i)
    EXPECT_EQ(posed.pose(i).matrix(), trajectory_.poses[i].matrix());
}

TEST_F(DriveViews, NameTheConventionOfWrongPoses)
{
  for (const PoseReading& truth : allReadings()) {
    if (areAlike(truth, {}))
      continue;
    PoseConventionCheck check;
    check.assess(recorded(truth));
    const PoseConventionReport& report = check.getReport();
    EXPECT_EQ(report.verdict, PoseVerdict::Contradicted) << textOf(truth);
    EXPECT_EQ(textOf(report.found), textOf(truth));
  }
}

TEST_F(DriveViews, RefuseWrongPosesWithTheOptionThatStatesThem)
{
  const PoseReading truth = {PoseConvention::OpenGl, 0.001};
  try {
    PoseConventionCheck().compute(recorded(truth));
    FAIL() << "wrong poses were taken";
  }
  catch (const InputFileException& fault) {
    EXPECT_THAT(fault.what(),
                HasSubstr("--pose-convention opengl --pose-scale 0.001 states it"));
  }
}

TEST_F(DriveViews, RefuseCloudsThatAreInOneFrame)
{
  std::vector<std::shared_ptr<const PointCloudFile>> moved;
  for (std::size_t i = 0; i < clouds_.size(); ++i) {
    PointCloud<PointXYZ> cloud;
    fromPCLPointCloud2(clouds_[i]->cloud, cloud);
    for (PointXYZ& point : cloud)
      point.getVector3fMap() =
          (trajectory_.poses[i] * point.getVector3fMap().cast<double>()).cast<float>();
    const auto file = std::make_shared<PointCloudFile>();
    toPCLPointCloud2(cloud, file->cloud);
    moved.push_back(file);
  }
  try {
    PoseConventionCheck().compute(ObservationSequence(moved, trajectory_));
    FAIL() << "the poses were taken";
  }
  catch (const InputFileException& fault) {
    EXPECT_THAT(fault.what(), HasSubstr("in one frame"));
  }
}

TEST_F(DriveViews, AgreeWithPosesThatAreStated)
{
  for (const PoseReading& truth : allReadings()) {
    PoseConventionCheck check;
    check.setConvention(truth.convention);
    check.setScale(truth.scale);
    const ObservationSequence posed = check.compute(recorded(truth));
    EXPECT_EQ(check.getReport().verdict, PoseVerdict::Agreeing) << textOf(truth);
    for (std::size_t i = 0; i < posed.size(); ++i)
      EXPECT_TRUE(posed.pose(i).isApprox(trajectory_.poses[i], 1e-9)) << textOf(truth);
  }
}

TEST_F(DriveViews, ContradictWhatIsStatedWrongly)
{
  PoseConventionCheck check;
  check.setConvention(PoseConvention::WorldToCamera);
  EXPECT_THROW(check.compute(recorded({})), InputFileException);
}

TEST_F(DriveViews, TellTheSameForEachNumberOfThreads)
{
  PoseConventionCheck check;
  std::vector<double> margins;
  for (const unsigned threads : {1, 2, 8}) {
    check.setNumberOfThreads(threads);
    check.assess(recorded({PoseConvention::WorldToCamera, 1}));
    margins.push_back(check.getReport().margin);
  }
  EXPECT_THAT(margins, testing::Each(margins.front()));
}

TEST_F(DriveViews, TellNothingWhereTheyAreTooFew)
{
  const Poses poses = {trajectory_.poses[1], trajectory_.poses[0]};
  const std::vector<std::shared_ptr<const PointCloudFile>> clouds(clouds_.begin(),
                                                                  clouds_.begin() + 2);
  PoseConventionCheck check;
  check.compute(ObservationSequence(clouds, {{0, 1}, poses}));
  EXPECT_EQ(check.getReport().verdict, PoseVerdict::Undetermined);
}

TEST_F(DriveViews, TellNothingOfOnePlace)
{
  Trajectory standing = trajectory_;
  for (Eigen::Isometry3d& pose : standing.poses)
    pose = trajectory_.poses[0];
  PoseConventionCheck check;
  check.compute(ObservationSequence(clouds_, standing));
  EXPECT_NE(check.getReport().verdict, PoseVerdict::Contradicted);
}

TEST_F(DriveViews, TellNothingOfPosesFarAway)
{
  Trajectory lost = trajectory_;
  for (std::size_t i = 0; i < lost.poses.size(); ++i)
    lost.poses[i].translation() *= 1e6 * static_cast<double>(i);
  PoseConventionCheck check;
  check.compute(ObservationSequence(clouds_, lost));
  EXPECT_NE(check.getReport().verdict, PoseVerdict::Agreeing);
}

TEST(PoseConventions, AreNotToldByViewsWithoutAPoint)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  PointCloud<PointXYZ> nothing;
  nothing.push_back({nan, nan, nan});
  const auto file = std::make_shared<PointCloudFile>();
  toPCLPointCloud2(nothing, file->cloud);
  Trajectory trajectory;
  for (int i = 0; i < 10; ++i) {
    trajectory.stamps.push_back(i);
    trajectory.poses.emplace_back(Eigen::Translation3d(i, 0, 0));
  }
  PoseConventionCheck check;
  check.compute(ObservationSequence({10, file}, trajectory));
  EXPECT_EQ(check.getReport().verdict, PoseVerdict::Undetermined);
}

TEST(PoseConventions, RefuseAScaleOfZero)
{
  PoseConventionCheck check;
  for (const double scale : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(check.setScale(scale), BadArgumentException);
  EXPECT_FALSE(check.getScale());
}

TEST(PoseConventions, OfTheKitchenAreFound)
{
  const std::string kitchen = "C_sequence/redkitchen_000_495";
  if (!hasTestData(kitchen + "/frame-000000.pose.txt"))
    GTEST_SKIP() << kitchen << " is missing";
  const RgbdSequence right = openRgbdSequence(testDataPath(kitchen).string());
  PoseConventionCheck check;
  check.compute(ObservationSequence(right, right.cameras()));
  EXPECT_EQ(check.getReport().verdict, PoseVerdict::Agreeing);
  for (const PoseReading& truth : {PoseReading{PoseConvention::WorldToCamera, 1},
                                   PoseReading{PoseConvention::OpenGl, 0.001}}) {
    RgbdSequence wrong = right;
    for (RgbdFrame& frame : wrong.frames)
      frame.T_world_camera = recordedAs(truth, loadPose(frame));
    const ObservationSequence views(wrong, wrong.cameras());
    check.assess(views);
    EXPECT_EQ(check.getReport().verdict, PoseVerdict::Contradicted);
    EXPECT_EQ(textOf(check.getReport().found), textOf(truth));
    PoseConventionCheck stated;
    stated.setConvention(truth.convention);
    stated.setScale(truth.scale);
    const ObservationSequence read = stated.compute(views);
    const ObservationSequence expected(right, right.cameras());
    for (std::size_t i = 0; i < read.size(); ++i)
      EXPECT_TRUE(read.pose(i).isApprox(expected.pose(i), 1e-9));
  }
}

/** Depths of which 1000 are a metre, as if 5000 were one. */
TEST(PoseConventions, DoNotTakeTheBlameOfDepths)
{
  const std::string kitchen = "C_sequence/redkitchen_000_495";
  if (!hasTestData(kitchen + "/frame-000000.pose.txt"))
    GTEST_SKIP() << kitchen << " is missing";
  RgbdSequence small = openRgbdSequence(testDataPath(kitchen).string());
  small.depth_scale *= 5;
  try {
    PoseConventionCheck().compute(ObservationSequence(small, small.cameras()));
    FAIL() << "the depths were taken";
  }
  catch (const InputFileException& fault) {
    EXPECT_THAT(fault.what(), HasSubstr("5 times too small: --depth-scale"));
  }
}

} // namespace
} // namespace pcl::acmap::test
