#include "messages.h"
#include "rgbd_folders.h"
#include "ros1_bag.h"
#include "sqlite_bag.h"
#include "temporary_folder.h"
#include "test_data.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/bag_scans.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/observation_source.h>

#include <gmock/gmock.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr double begin = 1500000000, pi = 3.14159265358979323846;

template <typename Value>
std::string
bytesOf(const std::vector<Value>& values)
{
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

Eigen::Isometry3d
placed(double x, double y, double z, double yaw = 0, double roll = 0)
{
  Eigen::Isometry3d pose(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                         Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()));
  pose.translation() << x, y, z;
  return pose;
}

/** A place of a robot that drives a curve. */
Eigen::Isometry3d
drivenAt(int i)
{
  return placed(0.1 * i, 0.02 * i, 0, 0.05 * i);
}

/** x ahead and z up of a camera with z ahead and y down. */
Eigen::Isometry3d
bodyOfCamera()
{
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return turn;
}

/** A bag of ROS 1 of RGB-D images of a frame, which a robot carries. */
class ImageBag {
public:
  explicit ImageBag(std::string frame, const std::string& child = "base_link")
  : frame_(std::move(frame))
  {
    Eigen::Matrix3d matrix;
    matrix << 10, 0, 3.5, 0, 20, 2.5, 0, 0, 1;
    for (const char* name : {"depth", "rgb"})
      bag_.add(
          std::string("/cam/") + name + "/camera_info",
          "sensor_msgs/CameraInfo",
          begin,
          cameraMessage<Ros1Bytes>(begin, frame_, small_width, small_height, matrix));
    for (int i = 0; i < 3; ++i)
      addFrame(i, child);
  }

  ImageBag&
  addFixed(const std::string& topic,
           const std::string& parent,
           const std::string& child,
           const Eigen::Isometry3d& pose)
  {
    for (int i = 0; i < 3; ++i)
      bag_.add(topic,
               "tf/tfMessage",
               begin + i,
               transformMessage<Ros1Bytes>(begin + i, parent, child, pose));
    return *this;
  }

  Ros1Writer&
  bag()
  {
    return bag_;
  }

  std::string
  write(const TemporaryFolder& folder)
  {
    return folder.write("images.bag", bag_.finish());
  }

private:
  void
  addFrame(int i, const std::string& child)
  {
    const double stamp = begin + 0.5 * i;
    bag_.add("/cam/depth/image",
             "sensor_msgs/Image",
             stamp,
             imageMessage<Ros1Bytes>(stamp,
                                     frame_,
                                     small_width,
                                     small_height,
                                     "16UC1",
                                     bytesOf(tellingDepths(i))));
    bag_.add("/cam/rgb/image_color",
             "sensor_msgs/Image",
             stamp,
             imageMessage<Ros1Bytes>(stamp,
                                     frame_,
                                     small_width,
                                     small_height,
                                     "rgb8",
                                     textOfBytes(tellingColors(i).values)));
    if (!child.empty())
      bag_.add("/odom",
               "nav_msgs/Odometry",
               stamp,
               odometryMessage<Ros1Bytes>(stamp, "odom", child, drivenAt(i)));
  }

  std::string frame_;
  Ros1Writer bag_{"lz4"};
};

/** Expects the poses of a camera on a robot. */
void
expectPoses(const ObservationSequence& sequence,
            const Eigen::Isometry3d& T_robot_camera)
{
  ASSERT_EQ(sequence.size(), 3U);
  ASSERT_TRUE(sequence.hasTrajectory());
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(sequence.pose(static_cast<std::size_t>(i))
                    .isApprox(T_robot_camera.inverse() * drivenAt(0).inverse() *
                                  drivenAt(i) * T_robot_camera,
                              1e-6))
        << i;
}

TEST(BagOfRos1, ImagesAreObservationsWithThePosesOfTheTree)
{
  const TemporaryFolder folder;
  const Eigen::Isometry3d T_base_camera = placed(0.1, 0, 0.5) * bodyOfCamera();
  ImageBag bag("/camera_rgb_optical_frame");
  bag.addFixed("/tf_static", "base_link", "camera_rgb_optical_frame", T_base_camera);
  const ObservationSequence sequence(openBag(bag.write(folder)));
  expectPoses(sequence, T_base_camera);
  EXPECT_THAT(sequence.remarks(), IsEmpty());
  const PosedObservation seen = sequence.load(1);
  const std::size_t pixel = 2 * small_width + 5;
  EXPECT_NEAR(seen.file->points()[pixel].z(), 0.001 * tellingDepths(1)[pixel], 1e-6);
}

TEST(BagOfRos1, MountingsThatAreRepeatedSeldomHoldAllTheTime)
{
  const TemporaryFolder folder;
  const Eigen::Isometry3d T_base_camera = placed(0.1, 0, 0.5) * bodyOfCamera();
  ImageBag bag("camera_optical");
  bag.addFixed("/tf", "base_link", "camera_optical", T_base_camera);
  expectPoses(ObservationSequence(openBag(bag.write(folder))), T_base_camera);
  // without odometry they are no poses
  ImageBag still("camera_optical", "");
  still.addFixed("/tf", "camera_link", "camera_optical", bodyOfCamera());
  EXPECT_FALSE(ObservationSequence(openBag(still.write(folder))).hasTrajectory());
}

TEST(BagOfRos1, PosesThatComeSlowlyAreInterpolated)
{
  const TemporaryFolder folder;
  Ros1Writer bag;
  const std::string row = bytesOf(std::vector<float>{1, 2, 3, 0});
  for (int i = 0; i <= 3; ++i)
    bag.add("/odom",
            "nav_msgs/Odometry",
            begin + i,
            odometryMessage<Ros1Bytes>(begin + i, "odom", "lidar", placed(i, 0, 0)));
  for (const double time : {0.0, 0.5, 1.75, 3.5}) // the last one is after all poses
    bag.add("/points",
            "sensor_msgs/PointCloud2",
            begin + time,
            cloudMessage<Ros1Bytes>(begin + time, "lidar", 1, 1, row));
  const ObservationSequence sequence(openBag(folder.write("slow.bag", bag.finish())));
  ASSERT_EQ(sequence.size(), 3U);
  EXPECT_NEAR(sequence.pose(1).translation().norm(), 0.5, 1e-9);
  EXPECT_NEAR(sequence.pose(2).translation().norm(), 1.75, 1e-9);
  EXPECT_THAT(sequence.remarks(), Contains(HasSubstr("1 observations left out")));
}

TEST(SensorMounting, OfACameraOnARobotIsStated)
{
  const TemporaryFolder folder;
  const std::string path = ImageBag("camera_color_optical_frame").write(folder);
  EXPECT_THAT(messageOf<InputFileException>([&] { openBag(path); }),
              AllOf(HasSubstr("no transform from base_link, which moves, to camera_"),
                    HasSubstr("--sensor-pose"),
                    HasSubstr("base_link moves in odom")));
  BagSettings settings;
  settings.T_robot_sensor = placed(0.1, 0, 0.5, 0.2);
  expectPoses(ObservationSequence(openBag(path, settings)),
              *settings.T_robot_sensor * bodyOfCamera());
  BagSettings none;
  none.ignores_poses = true;
  EXPECT_FALSE(ObservationSequence(openBag(path, none)).hasTrajectory());
  ImageBag known("camera_optical");
  known.addFixed("/tf_static", "base_link", "camera_optical", bodyOfCamera());
  EXPECT_THROW(openBag(known.write(folder), settings), BadArgumentException);
}

TEST(SensorMounting, FramesOfImagesAreThoseOfCameras)
{
  const TemporaryFolder folder;
  const std::string path = ImageBag("/rgb_camera_link").write(folder);
  EXPECT_THAT(messageOf<InputFileException>([&] { openBag(path); }),
              HasSubstr("base_link, which moves, to rgb_camera_link"));
  BagSettings settings;
  settings.T_robot_sensor = placed(0.1, 0, 0.5);
  expectPoses(ObservationSequence(openBag(path, settings)),
              *settings.T_robot_sensor * bodyOfCamera());
}

TEST(SensorMounting, OfTheFrameAboveTheCamera)
{
  const TemporaryFolder folder;
  ImageBag bag("camera_optical");
  bag.addFixed("/tf_static", "camera_link", "camera_optical", bodyOfCamera());
  const std::string path = bag.write(folder);
  EXPECT_THAT(messageOf<InputFileException>([&] { openBag(path); }),
              HasSubstr("to camera_link, the uppermost frame above camera_optical"));
  BagSettings settings;
  settings.T_robot_sensor = placed(0.1, 0, 0.5, 0.2);
  expectPoses(ObservationSequence(openBag(path, settings)),
              *settings.T_robot_sensor * bodyOfCamera());
}

TEST(SensorMounting, ACameraWhoseBodyIsTrackedLooksAhead)
{
  const TemporaryFolder folder;
  const ObservationSequence sequence(
      openBag(ImageBag("camera_color_optical_frame", "camera_link").write(folder)));
  expectPoses(sequence, bodyOfCamera());
  EXPECT_THAT(sequence.remarks(), Contains(HasSubstr("assumed that camera_color")));
}

/** Poses that a tracker or a SLAM program has recorded of the camera itself. */
TEST(SensorMounting, PosesOfAllTypesAreTaken)
{
  const TemporaryFolder folder;
  const auto poseBytes = [](double stamp, const Eigen::Isometry3d& pose) {
    return Ros1Bytes().addHeader(stamp, "world").addPose(pose).bytes;
  };
  ImageBag stamped("camera", ""), covariant("camera", ""), path("camera", ""),
      transforms("camera", "");
  Ros1Bytes all;
  all.addHeader(begin, "world").add(std::uint32_t{3});
  for (int i = 0; i < 3; ++i) {
    const double stamp = begin + 0.5 * i;
    const std::string pose = poseBytes(stamp, drivenAt(i));
    stamped.bag().add("/pose", "geometry_msgs/PoseStamped", stamp, pose);
    covariant.bag().add("/pose",
                        "geometry_msgs/PoseWithCovarianceStamped",
                        stamp,
                        pose + std::string(36 * sizeof(double), '\0'));
    all.bytes += pose;
    transforms.bag().add(
        "/vicon/camera",
        "geometry_msgs/TransformStamped",
        stamp,
        odometryMessage<Ros1Bytes>(stamp, "world", "camera", drivenAt(i)));
  }
  path.bag().add("/path", "nav_msgs/Path", begin + 2, all.bytes);
  for (ImageBag* const bag : {&stamped, &covariant, &path}) {
    const ObservationSequence sequence(openBag(bag->write(folder)));
    expectPoses(sequence, Eigen::Isometry3d::Identity());
    EXPECT_THAT(sequence.remarks(), Contains(HasSubstr("took the poses of /p")));
  }
  expectPoses(ObservationSequence(openBag(transforms.write(folder))),
              Eigen::Isometry3d::Identity());
}

TEST(SensorMounting, WheelsAreNotWhatIsTracked)
{
  const TemporaryFolder folder;
  ImageBag bag("camera_optical");
  for (int i = 0; i < 30; ++i)
    bag.bag().add(
        "/tf",
        "tf2_msgs/TFMessage",
        begin + 0.1 * i,
        transformMessage<Ros1Bytes>(
            begin + 0.1 * i, "base_link", "a_wheel", placed(0, 0.2, 0, 0, 0.3 * i)));
  BagSettings settings;
  settings.T_robot_sensor = placed(0, 0, 0.5);
  expectPoses(ObservationSequence(openBag(bag.write(folder), settings)),
              *settings.T_robot_sensor * bodyOfCamera());
}

TEST(BagRemarks, ClocksThatJumpAndStampsThatAreMissingAreTold)
{
  const TemporaryFolder folder;
  const std::string row = bytesOf(std::vector<float>{1, 2, 3, 0});
  Ros1Writer jumps, none;
  for (const int i : {0, 1, 2, 3}) {
    const double stamp = begin + (i < 2 ? 3600 : 0) + i;
    jumps.add("/points",
              "sensor_msgs/PointCloud2",
              begin + i,
              cloudMessage<Ros1Bytes>(stamp, "lidar", 1, 1, row));
    none.add("/points",
             "sensor_msgs/PointCloud2",
             begin + i,
             cloudMessage<Ros1Bytes>(0, "lidar", 1, 1, row));
  }
  const auto jumped = openBag(folder.write("jumps.bag", jumps.finish()));
  EXPECT_THAT(jumped->remarks(), Contains(HasSubstr("jumps back by up to 3599 s")));
  EXPECT_EQ(jumped->trajectory().stamps.front(), begin + 2);
  const auto unstamped = openBag(folder.write("none.bag", none.finish()));
  EXPECT_THAT(unstamped->remarks(), Contains(HasSubstr("have no stamps")));
  EXPECT_EQ(unstamped->trajectory().stamps.at(2), begin + 2);
}

TEST(BagTopicList, TellsWhatIsThereAndWhatReadsIt)
{
  const TemporaryFolder folder;
  const auto fault = [&](Ros1Writer bag) {
    const std::string path = folder.write("bag.bag", bag.finish());
    return messageOf<InputFileException>([&] { openBag(path); });
  };
  Ros1Writer packets;
  packets.add("/velodyne_packets", "velodyne_msgs/VelodyneScan", 1, "packet");
  EXPECT_THAT(fault(packets),
              AllOf(HasSubstr("neither depth images"),
                    HasSubstr("velodyne_pointcloud"),
                    HasSubstr("/velodyne_packets (1 of velodyne_msgs/VelodyneScan)")));
  Ros1Writer laser;
  laser.add(
      "/scan", "sensor_msgs/LaserScan", 1, scanMessage<Ros1Bytes>(1, "l", 0, 1, {}));
  EXPECT_THAT(fault(laser), HasSubstr("run pcl_entropy_rectification"));
  ImageBag images("optical", "");
  Ros1Writer depth_alone, odd;
  depth_alone.add("/depth",
                  "sensor_msgs/Image",
                  1,
                  imageMessage<Ros1Bytes>(1, "c", 1, 1, "16UC1", "\1\1"));
  EXPECT_THAT(fault(depth_alone),
              AllOf(HasSubstr("depth images in /depth, but no colours"),
                    HasSubstr("point_cloud_xyz")));
  Ros1Writer stereo;
  for (const char* topic : {"/left/image_rect", "/right/image_rect"})
    stereo.add(topic,
               "sensor_msgs/Image",
               1,
               imageMessage<Ros1Bytes>(1, "c", 1, 1, "mono8", "\1"));
  EXPECT_THAT(fault(stereo), HasSubstr("stereo_image_proc"));
  odd.add("/color",
          "sensor_msgs/Image",
          1,
          imageMessage<Ros1Bytes>(1, "c", 1, 1, "hsv8", "\1\1\1"));
  EXPECT_THAT(fault(odd), HasSubstr("/color: has colours as 'hsv8'"));
}

/** Readings of a laser in the middle of a square room of 6 m, from the right to the left
 * counter-clockwise by a degree. */
std::vector<float>
rangesAt(const Eigen::Isometry3d& laser, double side, double first, std::size_t beams)
{
  const Eigen::Vector3d ahead = laser.linear().col(0);
  std::vector<float> ranges;
  for (std::size_t i = 0; i < beams; ++i) {
    const double angle = std::atan2(ahead.y(), ahead.x()) +
                         side * (first + static_cast<double>(i) * pi / 180);
    const auto toWall = [&](double at, double way) {
      return way == 0 ? 1e9 : ((way > 0 ? 3 : -3) - at) / way;
    };
    ranges.push_back(
        static_cast<float>(std::min(toWall(laser.translation().x(), std::cos(angle)),
                                    toWall(laser.translation().y(), std::sin(angle)))));
  }
  return ranges;
}

/** A bag of scans of a robot in a room. */
template <typename Writer>
void
fillWithScans(Writer& bag, const Eigen::Isometry3d& T_base_laser, double side)
{
  using Bytes =
      std::conditional_t<std::is_same_v<Writer, SqliteWriter>, CdrBytes, Ros1Bytes>;
  const std::string infix = std::is_same_v<Writer, SqliteWriter> ? "/msg/" : "/";
  bag.add("/tf_static",
          "tf2_msgs" + infix + "TFMessage",
          begin,
          transformMessage<Bytes>(begin, "base_link", "laser", T_base_laser));
  for (int i = 0; i < 5; ++i) {
    const double stamp = begin + 0.2 * i;
    bag.add("/odom",
            "nav_msgs" + infix + "Odometry",
            stamp,
            odometryMessage<Bytes>(stamp, "odom", "base_link", drivenAt(i)));
    std::vector<float> ranges = rangesAt(drivenAt(i) * T_base_laser, side, -2, 270);
    ranges[3] = INFINITY;
    ranges[4] = 0.05F;
    bag.add(
        "/scan",
        "sensor_msgs" + infix + "LaserScan",
        stamp,
        scanMessage<Bytes>(stamp, "laser", -2, static_cast<float>(pi / 180), ranges));
  }
}

/** All echoes are on walls of the room. */
void
expectWalls(const BagScans& read)
{
  ASSERT_EQ(read.scans.size(), 5U);
  EXPECT_THAT(read.remarks, IsEmpty());
  for (const PlanarScan& scan : read.scans) {
    const PlanarScanPoints points = pointsOf(scan);
    EXPECT_EQ(points.missing_beams, 2U);
    for (const PointNormal& point : *points.cloud) {
      const Eigen::Vector3d wall =
          isometryOf(scan.pose) * point.getVector3fMap().cast<double>();
      EXPECT_NEAR(std::max(std::abs(wall.x()), std::abs(wall.z())), 3, 1e-3);
    }
  }
}

TEST(LaserBag, ScansHaveTheirAnglesAndPoses)
{
  const TemporaryFolder folder;
  const Eigen::Isometry3d T_base_laser = placed(0.2, 0.1, 0.3, 0.4);
  Ros1Writer ros1("bz2");
  fillWithScans(ros1, T_base_laser, 1);
  expectWalls(loadBagScans(folder.write("laser.bag", ros1.finish())));
  {
    SqliteWriter sqlite(folder.path("laser.db3"));
    fillWithScans(sqlite, T_base_laser, 1);
  }
  expectWalls(loadBagScans(folder.path("laser.db3")));
  EXPECT_EQ(loadBagScans(folder.path("laser.db3"), {2}).scans.size(), 3U);
  EXPECT_THROW(loadBagScans(folder.path("laser.db3"), {0}), BadArgumentException);
}

TEST(LaserBag, ALaserMayHangUpsideDown)
{
  const TemporaryFolder folder;
  Ros1Writer bag;
  fillWithScans(bag, placed(0.2, 0.1, 0.3, 0.4, pi), -1);
  expectWalls(loadBagScans(folder.write("laser.bag", bag.finish())));
}

TEST(LaserBag, BagsOfNoUseAreRefused)
{
  const TemporaryFolder folder;
  const auto fault = [&](Ros1Writer bag) {
    const std::string path = folder.write("bag.bag", bag.finish());
    return messageOf<InputFileException>([&] { loadBagScans(path); });
  };
  Ros1Writer tilted, unposed, empty;
  fillWithScans(tilted, placed(0, 0, 0, 0, pi / 2), 1);
  EXPECT_THAT(fault(tilted), HasSubstr("not in a horizontal plane"));
  unposed.add("/scan",
              "sensor_msgs/LaserScan",
              1,
              scanMessage<Ros1Bytes>(1, "l", 0, 1, {1, 2}));
  EXPECT_THAT(fault(unposed),
              AllOf(HasSubstr("has no poses for the scans"),
                    HasSubstr("/scan (1 of sensor_msgs/LaserScan)")));
  EXPECT_THAT(fault(empty), HasSubstr("has no laser scans"));
  Ros1Writer images;
  images.add("/c", "sensor_msgs/Image", 1, "");
  EXPECT_THAT(fault(images), HasSubstr("run pcl_compact_mapping"));
  BagSettings none;
  none.ignores_poses = true;
  EXPECT_THROW(loadBagScans(folder.path("bag.bag"), none), BadArgumentException);
}

TEST(BagTopicList, OfARobotOfOthers)
{
  const std::string name = "H_field/recordings/laser_and_odometry.mcap";
  if (!hasTestData(name))
    GTEST_SKIP() << name << " is not in the folder that ACMAP_TEST_DATA names";
  const std::string path = testDataPath(name).string();
  const auto tells = AllOf(HasSubstr("/odom (2639 of nav_msgs/msg/Odometry)"),
                           HasSubstr("/tf (5422 of"));
  EXPECT_THAT(messageOf<InputFileException>([&] { openBag(path); }), tells);
  EXPECT_THAT(messageOf<InputFileException>([&] { loadBagScans(path); }), tells);
}

/** A bag as RealSense's own recorder writes it: all frames are 0. */
TEST(BagOfRos1, RealSensesRecorderNamesNoFrames)
{
  const TemporaryFolder folder;
  Ros1Writer bag;
  const std::string depth = "/device_0/sensor_0/Depth_0",
                    infrared = "/device_0/sensor_0/Infrared_1",
                    color = "/device_0/sensor_1/Color_0";
  Eigen::Matrix3d matrix;
  matrix << 10, 0, 3.5, 0, 20, 2.5, 0, 0, 1;
  Eigen::Isometry3d T_color_depth = Eigen::Isometry3d::Identity();
  T_color_depth.translation().x() = 0.015;
  const std::vector<std::pair<std::string, Eigen::Isometry3d>> streams = {
      {depth, Eigen::Isometry3d::Identity()}, {color, T_color_depth}};
  for (const auto& [stream, pose] : streams) {
    bag.add(stream + "/info/camera_info",
            "sensor_msgs/CameraInfo",
            begin,
            cameraMessage<Ros1Bytes>(begin, "", small_width, small_height, matrix));
    bag.add(stream + "/tf/0",
            "geometry_msgs/Transform",
            begin,
            Ros1Bytes().addPose(pose).bytes);
    matrix(0, 0) = 12;
  }
  bag.add("/device_0/sensor_0/option/Depth_Units/value",
          "std_msgs/Float32",
          begin,
          Ros1Bytes().add(0.00025F).bytes);
  const auto addImage =
      [&](const std::string& stream, const char* encoding, const std::string& data) {
        bag.add(stream + "/image/data",
                "sensor_msgs/Image",
                begin,
                imageMessage<Ros1Bytes>(
                    begin, "0", small_width, small_height, encoding, data));
      };
  addImage(depth, "mono16", bytesOf(tellingDepths(1)));
  addImage("/device_0/sensor_0/Infrared_2", "mono16", bytesOf(tellingDepths(0)));
  addImage(infrared, "mono8", std::string(small_width * small_height, '\1'));
  addImage(color, "rgb8", textOfBytes(tellingColors(1).values));
  const ObservationSequence sequence(openBag(folder.write("d435.bag", bag.finish())));
  ASSERT_EQ(sequence.size(), 1U);
  // registered to the colours: a point of a depth is 15 mm aside, and a quarter as far
  const PosedObservation seen = sequence.load(0);
  std::size_t found = 0;
  const auto points = seen.file->points();
  for (std::size_t at = 0; at < points.size(); ++at)
    for (std::size_t i = 0; i < tellingDepths(1).size(); ++i) {
      const Eigen::Vector3f point = points[at];
      const double z = 0.00025 * tellingDepths(1)[i],
                   x = z * (static_cast<double>(i % small_width) - 3.5) / 10 + 0.015;
      found += std::abs(point.z() - z) < 1e-5 && std::abs(point.x() - x) < 1e-5;
    }
  EXPECT_GT(found, 3U);
}

} // namespace
} // namespace pcl::acmap::test
