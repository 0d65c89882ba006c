#include "e57_file.h"
#include "mcap_file.h"
#include "messages.h"
#include "rgbd_folders.h"
#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/observation_source.h>
#include <pcl/pipeline/rgbd_observation.h>

#include <gmock/gmock.h>

#include <cstring>

namespace pcl::acmap::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr double begin = 1700000000; // seconds, as a clock has them

constexpr const char *image_type = "sensor_msgs/msg/Image",
                     *camera_type = "sensor_msgs/msg/CameraInfo",
                     *cloud_type = "sensor_msgs/msg/PointCloud2",
                     *tf_type = "tf2_msgs/msg/TFMessage",
                     *odometry_type = "nav_msgs/msg/Odometry";

Eigen::Matrix3d
smallCamera()
{
  Eigen::Matrix3d matrix;
  matrix << 10, 0, 3.5, 0, 20, 2.5, 0, 0, 1;
  return matrix;
}

Eigen::Isometry3d
moved(double x, double y, double z)
{
  Eigen::Isometry3d pose(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()));
  pose.translation() << x, y, z;
  return pose;
}

template <typename Value>
std::string
bytesOf(const std::vector<Value>& values)
{
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

/** The pose of a frame halfway between two transforms. */
void
addPose(McapWriter& bag,
        double stamp,
        const std::string& parent,
        const std::string& child,
        const Eigen::Isometry3d& pose)
{
  for (const double way : {-0.02, 0.02}) {
    Eigen::Isometry3d near = pose;
    near.translation().x() += way;
    bag.add("/tf",
            tf_type,
            stamp + way,
            transformMessage(stamp + way, parent, child, near));
  }
}

void
addImages(McapWriter& bag,
          int frame,
          double stamp,
          const std::string& depth_frame,
          const std::string& color_frame)
{
  bag.add("/cam/depth/image_raw",
          image_type,
          stamp,
          imageMessage(stamp,
                       depth_frame,
                       small_width,
                       small_height,
                       "16UC1",
                       bytesOf(tellingDepths(frame))));
  const double later = stamp + 0.004;
  bag.add("/cam/color/image_raw",
          image_type,
          later,
          imageMessage(later,
                       color_frame,
                       small_width,
                       small_height,
                       "rgb8",
                       textOfBytes(tellingColors(frame).values)));
}

void
addCameras(McapWriter& bag)
{
  for (const char* name : {"depth", "color"})
    bag.add(std::string("/cam/") + name + "/camera_info",
            camera_type,
            begin,
            cameraMessage(begin, name, small_width, small_height, smallCamera()));
}

/** Images of three frames whose camera stands on a robot. */
std::string
bagOfImages(const Eigen::Isometry3d& T_base_camera, const std::string& color_frame)
{
  McapWriter bag("lz4");
  addCameras(bag);
  bag.add("/tf_static",
          tf_type,
          begin,
          transformMessage(begin, "base", "optical", T_base_camera));
  bag.add("/tf_static",
          tf_type,
          begin,
          transformMessage(begin, "optical", "other", moved(0.025, 0, 0)));
  for (int frame = 0; frame < 3; ++frame) {
    const double stamp = begin + 0.5 * frame;
    addImages(bag, frame, stamp, "optical", color_frame);
    addPose(bag, stamp, "odom", "base", posedAt(frame) * T_base_camera.inverse());
    bag.endChunk();
  }
  return bag.finish();
}

float
coordinate(const PointCloudFile& file, std::size_t i, std::size_t axis)
{
  return file.points()[i][static_cast<Eigen::Index>(axis)];
}

TEST(BagSource, ImagesAreObservationsWithThePosesOfTheTree)
{
  const TemporaryFolder folder;
  const std::string path =
      folder.write("robot.mcap", bagOfImages(moved(0.1, 0.2, 0.3), "optical"));
  const ObservationSequence sequence(openBag(path));
  ASSERT_EQ(sequence.size(), 3U);
  ASSERT_TRUE(sequence.hasTrajectory());
  EXPECT_EQ(sequence.stamp(1), begin + 0.5);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto frame = static_cast<int>(i);
    EXPECT_TRUE(sequence.pose(i).isApprox(posedAt(0).inverse() * posedAt(frame), 1e-6));
    const PosedObservation seen = sequence.load(i);
    const PointCloudFile& file = *seen.file;
    ASSERT_EQ(file.cloud.width, static_cast<std::uint32_t>(small_width));
    ASSERT_EQ(file.cloud.height, static_cast<std::uint32_t>(small_height));
    EXPECT_TRUE(std::isnan(coordinate(file, 0, 2)));
    const std::size_t pixel = 2 * small_width + 5;
    const double z = 0.001 * tellingDepths(frame)[pixel];
    EXPECT_NEAR(coordinate(file, pixel, 0), z * (5 - 3.5) / 10, 1e-6);
    EXPECT_NEAR(coordinate(file, pixel, 1), z * (2 - 2.5) / 20, 1e-6);
    EXPECT_NEAR(coordinate(file, pixel, 2), z, 1e-6);
  }
  EXPECT_EQ(ObservationSequence(openBag(path, {2})).size(), 2U);
  EXPECT_THAT(sequence.remarks(), testing::IsEmpty());
  EXPECT_THROW(openBag(path, {0}), BadArgumentException);
}

TEST(BagSource, ColoursOfAnotherCameraAreRegistered)
{
  const TemporaryFolder folder;
  const ObservationSequence sequence(
      openBag(folder.write("robot.mcap", bagOfImages(moved(0.1, 0.2, 0.3), "other"))));
  ASSERT_EQ(sequence.size(), 3U);
  const Eigen::Isometry3d T_depth_color = moved(0.025, 0, 0);
  EXPECT_TRUE(sequence.pose(2).isApprox(T_depth_color.inverse() * posedAt(0).inverse() *
                                            posedAt(2) * T_depth_color,
                                        1e-6));
}

/** A row of three points with colours. */
std::string
threePoints()
{
  return bytesOf(std::vector<float>{1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0});
}

TEST(BagSource, CloudsOfABodyAreTurnedToThoseOfACamera)
{
  const TemporaryFolder folder;
  McapWriter bag;
  const Eigen::Isometry3d T_base_lidar = moved(0, 0, 1);
  for (int i = 0; i < 4; ++i) {
    const double stamp = begin + 0.1 * i;
    bag.add("/points",
            cloud_type,
            stamp,
            cloudMessage(stamp, "lidar", 3, 1, threePoints()));
    bag.add("/odom",
            odometry_type,
            stamp,
            odometryMessage(stamp, "odom", "base", moved(i, 0, 0)));
  }
  bag.add("/tf_static",
          tf_type,
          begin,
          transformMessage(begin, "base", "lidar", T_base_lidar));
  const ObservationSequence sequence(openBag(folder.write("lidar.mcap", bag.finish())));
  ASSERT_EQ(sequence.size(), 4U);
  const PosedObservation first = sequence.load(0), third = sequence.load(2);
  EXPECT_EQ(first.file->points()[0], Eigen::Vector3f(-2, -3, 1));
  // points of both in the frame of the first lidar
  const auto inLidar = [&](const PosedObservation& seen) {
    const Eigen::Vector3d p = seen.T_map_camera * seen.file->points()[1].cast<double>();
    return Eigen::Vector3d(p.z(), -p.x(), -p.y());
  };
  EXPECT_LT((inLidar(first) - Eigen::Vector3d(4, 5, 6)).norm(), 1e-5);
  const Eigen::Isometry3d T_first_third =
      T_base_lidar.inverse() * moved(0, 0, 0).inverse() * moved(2, 0, 0) * T_base_lidar;
  EXPECT_LT((inLidar(third) - T_first_third * Eigen::Vector3d(4, 5, 6)).norm(), 1e-5);
}

TEST(BagSource, WithoutMovingFramesThereAreNoPoses)
{
  const TemporaryFolder folder;
  McapWriter bag("none");
  addCameras(bag);
  for (int frame = 0; frame < 2; ++frame)
    addImages(bag, frame, begin + frame, "optical", "optical");
  const ObservationSequence sequence(openBag(folder.write("still.mcap", bag.finish())));
  EXPECT_EQ(sequence.size(), 2U);
  EXPECT_FALSE(sequence.hasTrajectory());
}

TEST(BagSource, PosesOfAnotherTopicAreThoseOfTheSensor)
{
  const TemporaryFolder folder;
  McapWriter bag;
  addCameras(bag);
  for (int frame = 0; frame < 3; ++frame) {
    const double stamp = begin + frame;
    addImages(bag, frame, stamp, "optical", "optical");
    CdrBytes pose;
    pose.addHeader(stamp, "map").addPose(posedAt(frame));
    bag.add("/slam/pose", "geometry_msgs/msg/PoseStamped", stamp, pose.bytes);
  }
  addImages(bag, 3, begin + 3, "optical", "optical"); // after the last pose
  const ObservationSequence sequence(openBag(folder.write("slam.mcap", bag.finish())));
  ASSERT_EQ(sequence.size(), 3U);
  EXPECT_TRUE(sequence.pose(2).isApprox(posedAt(0).inverse() * posedAt(2), 1e-9));
  EXPECT_THAT(sequence.remarks(), Contains(HasSubstr("1 observations left out")));
}

TEST(BagSource, BagsOfNoUseAreRefused)
{
  const TemporaryFolder folder;
  const auto fault = [&](McapWriter& bag) -> std::string {
    return messageOf<InputFileException>(
        [&] { openBag(folder.write("bag.mcap", bag.finish())); }, "none");
  };
  McapWriter texts;
  texts.add("/talk", "std_msgs/msg/String", 1, "hello");
  EXPECT_THAT(fault(texts), HasSubstr("has neither depth images"));
  McapWriter without_camera;
  addImages(without_camera, 0, begin, "optical", "optical");
  EXPECT_THAT(fault(without_camera),
              HasSubstr("has no CameraInfo for /cam/depth/image_raw"));
  McapWriter apart;
  addCameras(apart);
  addImages(apart, 0, begin, "optical", "elsewhere");
  EXPECT_THAT(fault(apart), HasSubstr("no transform between the frames"));
  McapWriter broken;
  broken.add("/points", cloud_type, begin, std::string("\0\1\0\0\1", 5));
  EXPECT_THAT(fault(broken), HasSubstr("/points: ends early"));
}

TEST(ScanSource, ScansAreASequenceWithAShift)
{
  const TemporaryFolder folder;
  const std::string pose = "<pose><translation><x>452000.25</x></translation></pose>";
  const std::vector<Eigen::Vector3d> points = {{1, 2, 3}, {4, 5, 6}};
  const ObservationSequence sequence(openScans(
      folder.write("scans.e57", e57Of({scanOf(points, pose), scanOf(points)}))));
  ASSERT_EQ(sequence.size(), 2U);
  EXPECT_TRUE(sequence.hasTrajectory());
  EXPECT_EQ(sequence.shift(), Eigen::Vector3d(452000, 0, 0));
  EXPECT_EQ(sequence.pose(0).translation(), Eigen::Vector3d(0.25, 0, 0));
  EXPECT_EQ(sequence.load(1).file->points().size(), 2U);
  EXPECT_EQ(sequence.withShift({1, 2, 3}).shift(), Eigen::Vector3d(1, 2, 3));
  EXPECT_THROW(ObservationSequence(std::shared_ptr<const ObservationSource>()),
               BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
