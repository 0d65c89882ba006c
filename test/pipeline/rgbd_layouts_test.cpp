#include "messages.h"
#include "rgbd_folders.h"
#include "temporary_folder.h"
#include "test_png.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/rgbd_assessment.h>
#include <pcl/pipeline/rgbd_observation.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <sstream>

namespace pcl::acmap::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/** Layouts of other programs, with the frames of \ref tellingColors and so on. */
class RgbdLayouts : public testing::Test {
protected:
  RgbdSequence
  open(const RgbdSequenceSettings& settings = {}) const
  {
    return openRgbdSequence(folder_.path(""), settings);
  }

  std::string
  fault() const
  {
    return messageOf<InputFileException>([&] { open(); }, "no fault");
  }

  void
  createFolders(const std::vector<std::string>& names) const
  {
    for (const std::string& name : names)
      std::filesystem::create_directories(folder_.path(name));
  }

  void
  writeColor(const std::string& name, int frame, int factor = 1) const
  {
    folder_.write(name,
                  textOfBytes(encodePng(tellingColors(
                      frame, factor * small_width, factor * small_height))));
  }

  void
  writeDepth(const std::string& name, int frame) const
  {
    folder_.write(name, depthPngBytes(small_width, small_height, tellingDepths(frame)));
  }

  static std::string
  rowText(const Eigen::Isometry3d& pose, int rows)
  {
    std::ostringstream text;
    text.precision(17);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < 4; ++column)
        text << pose.matrix()(row, column) << " ";
    return text.str() + "\n";
  }

  static void
  expectPose(const RgbdFrame& frame, int expected)
  {
    EXPECT_TRUE(loadPose(frame).isApprox(posedAt(expected), 1e-6)) << expected;
  }

  TemporaryFolder folder_;
};

float
depthOf(const PCLPointCloud2& cloud, std::size_t pixel)
{
  float z = 0;
  std::memcpy(&z, &cloud.data[pixel * cloud.point_step + 8], sizeof z);
  return z;
}

TEST_F(RgbdLayouts, OfOrbSlamHaveTheScaleOfTum)
{
  createFolders({"rgb", "depth"});
  std::string rows, poses;
  for (int frame = 0; frame < 3; ++frame) {
    const std::string name = std::to_string(frame) + ".5.png";
    writeColor("rgb/" + name, frame);
    writeDepth("depth/" + name, frame);
    const std::string stamp = std::to_string(frame) + ".5";
    const std::string color = stamp + " rgb/" + name, depth = stamp + " depth/" + name;
    rows += frame == 1 ? depth + " " + color + "\n" : color + " " + depth + "\n";
    poses += poseRow(frame + 0.5, posedAt(frame));
  }
  folder_.write("associations.txt", rows);
  folder_.write("groundtruth.txt", poses);
  folder_.write("calibration.txt", "10 20 3.5 2.5\n");
  const RgbdSequence sequence = open();
  EXPECT_EQ(sequence.layout, "ORB-SLAM");
  EXPECT_EQ(sequence.depth_scale, 5000);
  EXPECT_EQ(sequence.camera.fy, 20);
  EXPECT_THAT(sequence.remarks, IsEmpty());
  ASSERT_EQ(sequence.frames.size(), 3U);
  EXPECT_THAT(sequence.frames[1].depth, HasSubstr("depth/1.5.png"));
  EXPECT_THAT(sequence.frames[1].color, HasSubstr("rgb/1.5.png"));
  expectPose(sequence.frames[2], 2);
  std::filesystem::remove(folder_.path("groundtruth.txt"));
  const RgbdSequence bare = open();
  EXPECT_FALSE(bare.has_poses);
  EXPECT_THAT(bare.remarks, ElementsAre(HasSubstr("has no poses")));
  folder_.write("associations.txt", "1 ../rgb/0.png 1 depth/0.png\n");
  EXPECT_THAT(fault(), HasSubstr("does not lie in the folder"));
  folder_.write("associations.txt", "1 rgb/0.png 1\n");
  EXPECT_THAT(fault(), HasSubstr("line 1: has 3 words"));
}

TEST_F(RgbdLayouts, OfScannetLeaveOutLostPosesAndHaveLargerColors)
{
  createFolders({"color", "depth", "pose", "intrinsic"});
  for (int frame = 0; frame < 12; ++frame) {
    const std::string name = std::to_string(frame);
    writeColor("color/" + name + ".png", frame, 2);
    writeDepth("depth/" + name + ".png", frame);
    folder_.write("pose/" + name + ".txt",
                  frame == 1 ? "-inf -inf -inf -inf\n-inf -inf -inf -inf\n"
                               "-inf -inf -inf -inf\n-inf -inf -inf -inf\n"
                             : matrixText(posedAt(frame).matrix()));
  }
  folder_.write("intrinsic/intrinsic_depth.txt",
                "10 0 3.5 0\n0 20 2.5 0\n0 0 1 0\n0 0 0 1\n");
  folder_.write("intrinsic/intrinsic_color.txt",
                "20 0 7.5 0\n0 40 5.5 0\n0 0 1 0\n0 0 0 1\n");
  const RgbdSequence sequence = open();
  EXPECT_EQ(sequence.layout, "ScanNet");
  EXPECT_EQ(sequence.unposed, 1U);
  ASSERT_EQ(sequence.frames.size(), 11U);
  expectPose(sequence.frames[1], 2);
  expectPose(sequence.frames[10], 11);
  ASSERT_TRUE(sequence.color_camera);
  const RgbdCameras cameras = sequence.cameras();
  EXPECT_TRUE(loadPose(sequence.frames[1], cameras).isApprox(posedAt(2), 1e-9));
  const RgbdObservation seen = loadRgbdObservation(sequence.frames[0], cameras);
  EXPECT_EQ(seen.cloud.width, 8U) << "that of the depth image";
  EXPECT_EQ(seen.sizes.color.width, 16);
  EXPECT_FLOAT_EQ(depthOf(seen.cloud, 5),
                  0.001F * static_cast<float>(tellingDepths(0)[5]));
  std::uint32_t rgb = 0; // of column 5 in row 3: the mean of columns 10, 11, rows 6, 7
  std::memcpy(&rgb, &seen.cloud.data[29 * seen.cloud.point_step + 12], sizeof rgb);
  EXPECT_NEAR(rgb >> 16 & 255, 10 + 6.5, 1);
  EXPECT_NEAR(rgb >> 8 & 255, 200 + 10.5, 1);
}

TEST_F(RgbdLayouts, OfReplicaHaveTheScaleOfTheirFile)
{
  createFolders({"room0/results"});
  std::string poses;
  for (int frame = 0; frame < 3; ++frame) {
    writeColor("room0/results/frame00000" + std::to_string(frame) + ".png", frame);
    writeDepth("room0/results/depth00000" + std::to_string(frame) + ".png", frame);
    poses += rowText(posedAt(frame), 4);
  }
  folder_.write("room0/traj.txt", poses);
  const std::string scene = folder_.path("room0");
  EXPECT_THAT(openRgbdSequence(scene).remarks, Contains(HasSubstr("took Replica's")));
  EXPECT_EQ(openRgbdSequence(scene).depth_scale, 6553.5);
  folder_.write("cam_params.json",
                R"({"camera": {"w": 16, "h": 12, "fx": 20.0, "fy": 40.0, "cx": 7.5,
                    "cy": 5.5, "scale": 1250.0}})");
  const RgbdSequence sequence = openRgbdSequence(scene);
  EXPECT_EQ(sequence.layout, "Replica");
  EXPECT_EQ(sequence.depth_scale, 1250);
  EXPECT_THAT(sequence.remarks, ElementsAre(HasSubstr("images of 16 x 12 pixels")));
  EXPECT_EQ(sequence.camera.fx, 10) << "scaled";
  EXPECT_EQ(sequence.camera.cx, 3.5);
  expectPose(sequence.frames[2], 2);
}

TEST_F(RgbdLayouts, OfStrayScannerHaveConfidences)
{
  createFolders({"depth", "confidence"});
  std::string rows = "timestamp, frame, x, y, z, qx, qy, qz, qw\n";
  for (int frame = 0; frame < 3; ++frame) {
    const std::string name = "00000" + std::to_string(frame) + ".png";
    writeDepth("depth/" + name, frame);
    std::vector<std::uint8_t> trusted(small_width * small_height, 2);
    trusted[5] = 0;
    folder_.write("confidence/" + name,
                  textOfBytes(encodePng(small_width, small_height, trusted)));
    std::istringstream words(poseRow(7.5 + frame, posedAt(frame)));
    std::string word, row;
    words >> row;
    row += ", 00000" + std::to_string(frame);
    while (words >> word)
      row += ", " + word;
    if (frame != 1)
      rows += row + "\n";
  }
  folder_.write("odometry.csv", rows);
  folder_.write("camera_matrix.csv", "10, 0, 3.5\n0, 20, 2.5\n0, 0, 1\n");
  folder_.write("rgb.mp4", "");
  RgbdSequence sequence = open();
  EXPECT_EQ(sequence.layout, "StrayScanner");
  EXPECT_THAT(sequence.remarks, Contains(HasSubstr("ffmpeg -noautorotate")));
  EXPECT_EQ(sequence.unposed, 1U);
  ASSERT_EQ(sequence.frames.size(), 2U);
  EXPECT_EQ(sequence.frames[1].stamp, 9.5);
  expectPose(sequence.frames[1], 2);
  const RgbdObservation seen =
      loadRgbdObservation(sequence.frames[0], sequence.cameras());
  EXPECT_TRUE(std::isnan(depthOf(seen.cloud, 5)));
  EXPECT_FALSE(std::isnan(depthOf(seen.cloud, 6)));
  createFolders({"rgb"});
  for (int frame = 0; frame < 3; ++frame)
    writeColor("rgb/" + std::to_string(frame) + ".png", frame, 3);
  sequence = open();
  EXPECT_THAT(assessRgbd(sequence, sequence.cameras()).remarks,
              ElementsAre(HasSubstr("24 x 18 pixels are scaled")));
  EXPECT_EQ(loadRgbdObservation(sequence.frames[0], sequence.cameras()).cloud.width,
            8U);
}

TEST_F(RgbdLayouts, OfRecord3dHaveCamerasThatLookBackward)
{
  createFolders({"rgb", "depth"});
  std::ostringstream poses;
  poses.precision(17);
  for (int frame = 0; frame < 2; ++frame) {
    writeColor("rgb/" + std::to_string(frame) + ".png", frame);
    writeDepth("depth/" + std::to_string(frame) + ".png", frame);
    const Eigen::Isometry3d turned =
        posedAt(frame) * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX());
    const Eigen::Quaterniond q(turned.linear());
    const Eigen::Vector3d t = turned.translation();
    poses << (frame > 0 ? ", [" : "[") << q.x() << "," << q.y() << "," << q.z() << ","
          << q.w() << "," << t.x() << "," << t.y() << "," << t.z() << "]";
  }
  folder_.write(
      "metadata.json",
      R"({"w": 8, "h": 6, "K": [10, 0, 0, 0, 20, 0, 3.5, 2.5, 1], "poses": [)" +
          poses.str() + "]}");
  const RgbdSequence sequence = open();
  EXPECT_EQ(sequence.layout, "Record3D");
  EXPECT_THAT(sequence.remarks, IsEmpty());
  EXPECT_EQ(sequence.camera.cy, 2.5);
  ASSERT_EQ(sequence.frames.size(), 2U);
  expectPose(sequence.frames[1], 1);
}

TEST_F(RgbdLayouts, WhoseNamesAreTimesArePairedByThem)
{
  createFolders({"rgb", "depth"});
  std::string poses;
  for (int frame = 0; frame < 6; ++frame) {
    const double time = 1305031102 + 0.25 * frame;
    std::ostringstream depth, color;
    depth << std::fixed << "depth/" << time << ".png";
    color << std::fixed << "rgb/" << time + 0.004 << ".png";
    if (frame != 4)
      writeDepth(depth.str(), frame);
    if (frame != 1)
      writeColor(color.str(), frame);
    poses += poseRow(time, posedAt(frame));
  }
  folder_.write("groundtruth.txt", poses);
  folder_.write("depth/.DS_Store", "");
  folder_.write("rgb/._1.png", "");
  folder_.write("rgb/README.txt", "");
  const RgbdSequence sequence = open();
  ASSERT_EQ(sequence.frames.size(), 4U);
  EXPECT_EQ(sequence.unmatched, 1U);
  EXPECT_EQ(sequence.frames[1].stamp, 1305031102.5);
  const int expected[] = {0, 2, 3, 5};
  for (std::size_t i = 0; i < 4; ++i) {
    expectPose(sequence.frames[i], expected[i]);
    EXPECT_EQ(loadRgbImage(sequence.frames[i].color).values[2], expected[i]);
  }
}

TEST_F(RgbdLayouts, WhoseNamesHaveNumbersArePairedByThem)
{
  createFolders({"Color", "depth"});
  std::string poses;
  for (int frame = 0; frame < 11; ++frame) {
    if (frame != 3)
      writeDepth("depth/d" + std::to_string(frame) + ".png", frame);
    if (frame != 5)
      writeColor("Color/frame-0" + std::to_string(100 + frame).substr(1) + ".PNG",
                 frame);
    poses += rowText(posedAt(frame), 3);
  }
  folder_.write("poses.txt", poses);
  const RgbdSequence sequence = open();
  ASSERT_EQ(sequence.frames.size(), 9U);
  for (const RgbdFrame& frame : sequence.frames) {
    const int number = loadRgbImage(frame.color).values[2];
    EXPECT_THAT(frame.depth, HasSubstr("d" + std::to_string(number) + ".png"));
    expectPose(frame, number);
  }
  EXPECT_THAT(sequence.remarks, Not(Contains(HasSubstr("in their order"))));
}

TEST_F(RgbdLayouts, PairedInTheirOrderAreTold)
{
  createFolders({"rgb", "depth"});
  for (int frame = 0; frame < 2; ++frame) {
    writeDepth(frame == 0 ? "depth/a.png" : "depth/b.png", frame);
    writeColor(frame == 0 ? "rgb/left.png" : "rgb/right.png", frame);
  }
  const RgbdSequence sequence = open();
  EXPECT_FALSE(sequence.has_poses);
  EXPECT_THAT(sequence.remarks, Contains(HasSubstr("took them in their order")));
}

TEST_F(RgbdLayouts, ThatAreNotReadNameTheCommand)
{
  createFolders({"rgb", "depth"});
  writeColor("rgb/0.png", 0);
  folder_.write("depth/0.npy", "");
  EXPECT_THAT(fault(), HasSubstr("numpy.load"));
  std::filesystem::remove_all(folder_.path("depth"));
  folder_.write("scene.sens", "");
  EXPECT_THAT(fault(), HasSubstr("SensReader"));
  std::filesystem::remove(folder_.path("scene.sens"));
  folder_.write("output.mkv", "");
  EXPECT_THAT(fault(), HasSubstr("azure_kinect_mkv_reader"));
}

TEST_F(RgbdLayouts, HaveTheirCameraInFilesOfManyNames)
{
  createFolders({"rgb", "depth"});
  writeColor("rgb/0.png", 0);
  writeDepth("depth/0.png", 0);
  const std::string matrix = "10 0 3.5\n0 20 2.5\n0 0 1\n";
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"cam_K.txt", matrix},
           {"intrinsics.txt", matrix},
           {"K.txt", "10 20 3.5 2.5\n"},
           {"camera.yaml",
            "image_width: 8\nimage_height: 6\ndistortion_model: plumb_bob\n"
            "camera_matrix: [10, 0, 3.5, 0, 20, 2.5, 0, 0, 1]\n"},
           {"camera_intrinsic.json",
            R"({"width": 16, "height": 12, "intrinsic_matrix": )"
            R"([20, 0, 0, 0, 40, 0, 7.5, 5.5, 1]})"}}) {
    folder_.write(name, text);
    const RgbdSequence sequence = open();
    EXPECT_EQ(sequence.camera.fx, 10) << name;
    EXPECT_EQ(sequence.camera.fy, 20) << name;
    EXPECT_EQ(sequence.camera.cx, 3.5) << name;
    EXPECT_EQ(sequence.camera.cy, 2.5) << name;
    EXPECT_THAT(sequence.remarks, Not(Contains(HasSubstr("tells the camera")))) << name;
    std::filesystem::remove(folder_.path(name));
  }
  folder_.write("K.txt", "10 20\n");
  EXPECT_THAT(fault(), HasSubstr("K.txt"));
}

/** nerfstudio's and Polycam's files have frames in any order. */
TEST_F(RgbdLayouts, OfNerfstudioHaveCamerasThatLookBackward)
{
  createFolders({"images", "depth"});
  std::string frames;
  for (const int frame : {2, 0, 1}) {
    const std::string number = "0000" + std::to_string(frame + 7);
    writeColor("images/" + number + ".png", frame);
    writeDepth("depth/" + number + ".png", frame);
    const Eigen::Isometry3d turned =
        posedAt(frame) * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX());
    std::ostringstream rows;
    rows.precision(17);
    for (int row = 0; row < 4; ++row)
      rows << (row > 0 ? ", [" : "[") << turned.matrix()(row, 0) << ", "
           << turned.matrix()(row, 1) << ", " << turned.matrix()(row, 2) << ", "
           << turned.matrix()(row, 3) << "]";
    frames += (frames.empty() ? "" : ", ") + (R"({"file_path": "images/)" + number) +
              R"(.png", "transform_matrix": [)" + rows.str() + "]}";
  }
  const std::string text =
      R"({"fl_x": 10, "fl_y": 20, "cx": 3.5, "cy": 2.5, "w": 8, "h": 6, "frames": [)" +
      frames + "]}";
  folder_.write("transforms.json", text);
  const RgbdSequence sequence = open();
  EXPECT_THAT(sequence.remarks, IsEmpty());
  EXPECT_EQ(sequence.camera.fy, 20);
  ASSERT_EQ(sequence.frames.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    expectPose(sequence.frames[i], static_cast<int>(i));
    EXPECT_EQ(loadRgbImage(sequence.frames[i].color).values[2], i);
  }
  folder_.write("transforms.json", R"({"fl_x": 10, "fl_y": 20, "cx": 3.5, "cy": 2.5,
      "frames": [{"file_path": "7.png", "transform_matrix": [[2, 0, 0, 0]]}]})");
  EXPECT_THAT(fault(), HasSubstr("transforms.json: line 2"));
}

/** 3RScan, VoxelHashing and early exports of ScanNet. */
TEST_F(RgbdLayouts, OfSevenScenesMayHaveTheirCamerasInAnInfo)
{
  writeColor("frame-000000.color.png", 0, 3);
  writeDepth("frame-000000.depth.png", 0);
  folder_.write("frame-000000.pose.txt",
                rowText(posedAt(0), 1) + rowText(posedAt(0), 1));
  folder_.write(
      "_info.txt",
      "m_versionNumber = 4\nm_sensorName = some phone\nm_depthWidth = 8\n"
      "m_depthHeight = 6\nm_depthShift = 500\n"
      "m_calibrationColorIntrinsic = 30 0 10.5 0 0 60 7.5 0 0 0 1 0 0 0 0 1\n"
      "m_calibrationDepthIntrinsic = 10 0 3.5 0 0 20 2.5 0 0 0 1 0 0 0 0 1\n");
  const RgbdSequence sequence = open();
  EXPECT_EQ(sequence.depth_scale, 500);
  EXPECT_EQ(sequence.camera.fy, 20);
  EXPECT_THAT(sequence.remarks, IsEmpty());
  ASSERT_TRUE(sequence.color_camera);
  EXPECT_EQ(sequence.color_camera->pinhole.fx, 30);
  EXPECT_EQ(loadRgbdObservation(sequence.frames[0], sequence.cameras()).cloud.width,
            8U);
  folder_.write("_info.txt", "m_depthShift = 500\n");
  EXPECT_THAT(fault(), HasSubstr("m_calibrationDepthIntrinsic"));
  folder_.write("_info.txt", "m_depthWidth = 1e30\n");
  EXPECT_THAT(fault(), HasSubstr("line 1: m_depthWidth"));
}

TEST_F(RgbdLayouts, AboveARecordingNameIt)
{
  createFolders({"seq-01/rgb", "seq-01/depth", "empty"});
  EXPECT_THAT(fault(), HasSubstr("has one: " + folder_.path("seq-01")));
}

TEST_F(RgbdLayouts, WithTurnedColorsAreRefused)
{
  createFolders({"rgb", "depth"});
  writeDepth("depth/0.png", 0);
  folder_.write("rgb/0.png", textOfBytes(encodePng(tellingColors(0, 12, 16))));
  const RgbdSequence sequence = open();
  EXPECT_THAT(messageOf<InputFileException>(
                  [&] { loadRgbdObservation(sequence.frames[0], sequence.cameras()); },
                  "no fault"),
              HasSubstr("one of them is turned"));
}

TEST_F(RgbdLayouts, MayHaveDepthsAsPgm)
{
  createFolders({"rgb", "depth"});
  writeColor("rgb/0.png", 0);
  std::string bytes = "P5\n8 6\n65535\n";
  for (const std::uint16_t depth : tellingDepths(0)) {
    bytes += static_cast<char>(depth >> 8);
    bytes += static_cast<char>(depth & 255);
  }
  folder_.write("depth/0.pgm", bytes);
  const RgbdSequence sequence = open();
  const RgbdObservation seen =
      loadRgbdObservation(sequence.frames[0], sequence.cameras());
  EXPECT_FLOAT_EQ(depthOf(seen.cloud, 9),
                  0.001F * static_cast<float>(tellingDepths(0)[9]));
  folder_.write("depth/0.pgm", bytes.substr(0, 50));
  EXPECT_THROW(loadRgbdObservation(sequence.frames[0], sequence.cameras()),
               InputFileException);
}

/** A recording of a Kinect's depths of boxes before a wall, with colours that show the edges.
 * \param[in] unit numbers in a metre
 * \param[in] shift of the colours, pixels */
void
writeBoxes(const TemporaryFolder& folder, double unit, int shift)
{
  constexpr int width = 320, height = 240;
  std::filesystem::create_directory(folder.path("color"));
  std::filesystem::create_directory(folder.path("depth"));
  const auto boxAt = [](int column, int row) {
    return column / 40 % 2 == 1 && row / 30 % 2 == 1;
  };
  std::vector<std::uint16_t> depths;
  RgbImage color{width, height, {}};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      constexpr double step = 0.00285;
      const double z = boxAt(column, row) ? 1.2 + 0.002 * row : 2 + 0.01 * column;
      const double level = std::round(1 / (z * step));
      depths.push_back(static_cast<std::uint16_t>(std::lround(unit / (level * step))));
      for (int i = 0; i < 3; ++i)
        color.values.push_back(boxAt(column - shift, row) ? 200 : 60);
    }
  folder.write("color/0.png", textOfBytes(encodePng(color)));
  folder.write("depth/0.png", depthPngBytes(width, height, depths));
  folder.write("camera_intrinsic.json",
               R"({"width": 320, "height": 240,
                   "intrinsic_matrix": [290, 0, 0, 0, 290, 0, 159.5, 119.5, 1]})");
}

RgbdAssessment
assessed(const TemporaryFolder& folder, double scale)
{
  const RgbdSequence sequence = openRgbdSequence(folder.path(""));
  RgbdCameras cameras = sequence.cameras();
  cameras.meaning.scale = scale;
  return assessRgbd(sequence, cameras);
}

TEST(RgbdAssessments, TellTheScaleByTheStepsOfAKinect)
{
  for (const double unit : {1000.0, 5000.0}) {
    const TemporaryFolder folder;
    writeBoxes(folder, unit, 0);
    const RgbdAssessment right = assessed(folder, unit);
    EXPECT_THAT(right.remarks, IsEmpty());
    EXPECT_NEAR(right.median_depth, 3, 0.3);
    ASSERT_TRUE(right.scale_of_steps);
    EXPECT_NEAR(*right.scale_of_steps, unit, 0.1 * unit);
    EXPECT_THAT(assessed(folder, unit == 1000 ? 5000 : 1000).remarks,
                ElementsAre(HasSubstr("--depth-scale")));
  }
}

TEST(RgbdAssessments, TellColorsThatAreShifted)
{
  const TemporaryFolder straight, shifted;
  writeBoxes(straight, 1000, 0);
  writeBoxes(shifted, 1000, 12);
  const RgbdAssessment right = assessed(straight, 1000);
  ASSERT_TRUE(right.color_shift);
  EXPECT_LT(right.color_shift->norm(), 3);
  const RgbdAssessment wrong = assessed(shifted, 1000);
  ASSERT_TRUE(wrong.color_shift);
  EXPECT_NEAR(wrong.color_shift->x(), 12, 2);
  EXPECT_NEAR(wrong.color_shift->y(), 0, 2);
  EXPECT_THAT(wrong.remarks, ElementsAre(HasSubstr("--color-camera")));
}

} // namespace
} // namespace pcl::acmap::test
