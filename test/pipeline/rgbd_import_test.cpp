#include "rgbd_folders.h"
#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/output_folder.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/rgbd_import.h>
#include <pcl/pipeline/rgbd_statement.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace pcl::acmap::test {
namespace {

class RgbdImports : public testing::Test {
protected:
  RgbdImports()
  {
    writeSevenScenes(recording_, 5);
  }

  RgbdImport
  import(const RgbdImportSettings& settings) const
  {
    const RgbdSequence recorded = openRgbdSequence(recording_.path(""));
    OutputFolder folder(written_.path("clouds"));
    RgbdImport import = importRgbd(recorded, recorded.cameras(), folder, settings);
    folder.commit();
    return import;
  }

  TemporaryFolder recording_, written_;
};

TEST_F(RgbdImports, WriteEachNthFrameRelativeToTheFirst)
{
  RgbdImportSettings settings;
  settings.every = 2;
  const RgbdImport written = import(settings);
  ASSERT_EQ(written.trajectory.poses.size(), 3U);
  EXPECT_TRUE(written.trajectory.poses[0].isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_EQ(written.size.width, small_width);
  EXPECT_GT(written.points, 0U);
  EXPECT_GT(written.median_depth, 1);
  EXPECT_NEAR(written.finite_share,
              static_cast<double>(written.points) / (3 * small_width * small_height),
              1e-12);
  const ObservationSequence sequence(written_.path("clouds"));
  EXPECT_EQ(sequence.size(), 3U);
  settings.every = SIZE_MAX;
  EXPECT_EQ(import(settings).trajectory.poses.size(), 1U);
  settings.every = 0;
  EXPECT_EQ(import(settings).trajectory.poses.size(), 5U);
}

TEST_F(RgbdImports, LeaveOutBrokenFramesIfTheyMay)
{
  recording_.write("frame-000000.depth.png", "no picture");
  EXPECT_THROW(import({}), InputFileException);
  RgbdImportSettings settings;
  settings.skip_broken = true;
  const RgbdImport written = import(settings);
  EXPECT_EQ(written.trajectory.poses.size(), 4U);
  EXPECT_TRUE(written.trajectory.poses[0].isApprox(Eigen::Isometry3d::Identity()))
      << "the first camera is that of the first frame that is whole";
  ASSERT_EQ(written.broken.size(), 1U);
  EXPECT_NE(written.broken[0].find("frame-000000.depth.png"), std::string::npos);
}

TEST_F(RgbdImports, OfNothingWriteNothing)
{
  RgbdSequence none = openRgbdSequence(recording_.path(""));
  none.frames.clear();
  const OutputFolder folder(written_.path("none"));
  const RgbdImport written = importRgbd(none, none.cameras(), folder);
  EXPECT_TRUE(written.trajectory.poses.empty());
  EXPECT_EQ(written.points, 0U);
  EXPECT_EQ(written.finite_share, 0);
}

TEST_F(RgbdImports, CamerasMayBeStated)
{
  RgbdStatement stated;
  stated.no_poses = true;
  stated.fx = 11;
  stated.cx = 3;
  stated.depth_scale = 500;
  stated.max_depth = 2;
  const RgbdSequence recorded =
      openRgbdSequence(recording_.path(""), settingsOf(stated));
  EXPECT_FALSE(recorded.has_poses);
  const RgbdCameras cameras = camerasOf(stated, recorded);
  EXPECT_EQ(cameras.depth.fx, 11);
  EXPECT_EQ(cameras.depth.fy, 11);
  EXPECT_EQ(cameras.depth.cx, 3);
  EXPECT_EQ(cameras.depth.cy, 2.5) << "the folder's";
  EXPECT_EQ(cameras.meaning.scale, 500);
  stated.is_registered = true;
  EXPECT_FALSE(camerasOf(stated, recorded).color);
  stated.intrinsics = recording_.path("none.yaml");
  EXPECT_THROW(camerasOf(stated, recorded), InputFileException);
  EXPECT_EQ(depthSizeOf(recorded).width, small_width);
  EXPECT_THROW(depthSizeOf({}), BadArgumentException);
}

TEST_F(RgbdImports, PosesMayBeReadBefore)
{
  RgbdSequence recorded = openRgbdSequence(recording_.path(""));
  const RgbdCameras cameras = recorded.cameras();
  ASSERT_TRUE(readRecordedPoses(PoseConventionCheck(), cameras, recorded));
  for (const RgbdFrame& frame : recorded.frames)
    EXPECT_TRUE(frame.T_world_camera.has_value());
  recorded.has_poses = false;
  EXPECT_FALSE(readRecordedPoses(PoseConventionCheck(), cameras, recorded));
}

} // namespace
} // namespace pcl::acmap::test
