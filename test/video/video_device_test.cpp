#include "video_device.h"

#include "temporary_folder.h"
#include "thrown_faults.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

TEST(VideoDevice, IsWhatItsNameSays)
{
  const TemporaryFolder folder;
  const std::string file = folder.write("left.mkv", "");
  EXPECT_EQ(findVideoDevice(file).kind, VideoKind::File);
  EXPECT_EQ(findVideoDevice(folder.path("left_%04d.png")).kind, VideoKind::Images);
  EXPECT_EQ(findVideoDevice("rtsp://camera/left").kind, VideoKind::Network);
  EXPECT_EQ(findVideoDevice("videotestsrc ! appsink").kind, VideoKind::Pipeline);
  EXPECT_EQ(findVideoDevice("/dev/null").kind, VideoKind::Camera); // a device file
}

TEST(VideoDevice, ThatIsMissingIsNamed)
{
  std::string message;
  EXPECT_EQ(faultOf([] { findVideoDevice("4711"); }, &message), CameraFault::NotFound);
  EXPECT_THAT(message, HasSubstr("/dev/video4711"));
  const TemporaryFolder folder;
  EXPECT_THROW(findVideoDevice(folder.path("")), InputFileException);
}

TEST(VideoDevice, IsTheSameUnderAnyName)
{
  const TemporaryFolder folder;
  const std::string file = folder.write("left.mkv", "");
  std::filesystem::create_symlink(file, folder.path("link.mkv"));
  EXPECT_TRUE(isSameVideo(file, folder.path("link.mkv")));
  EXPECT_TRUE(isSameVideo("7", "7"));
  EXPECT_FALSE(isSameVideo("7", "8"));
  EXPECT_FALSE(isSameVideo(file, folder.write("right.mkv", "")));
}

} // namespace
} // namespace pcl::acmap::test
