#include "messages.h"
#include "rgbd_folders.h"
#include "temporary_folder.h"
#include "test_png.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/rgbd_observation.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <gmock/gmock.h>

#include <cstring>
#include <filesystem>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

template <typename Function>
std::string
faultOf(const Function& function)
{
  return messageOf<InputFileException>(function, "no fault");
}

RgbdSequenceSettings
withoutPoses()
{
  RgbdSequenceSettings settings;
  settings.has_poses = false;
  return settings;
}

class RgbdFolders : public testing::Test {
protected:
  RgbdSequence
  open(const RgbdSequenceSettings& settings = {}) const
  {
    return openRgbdSequence(folder_.path(""), settings);
  }

  TemporaryFolder folder_;
};

TEST_F(RgbdFolders, OfSevenScenesAreListed)
{
  writeSevenScenes(folder_, 3);
  const RgbdSequence sequence = open();
  EXPECT_EQ(sequence.folder, folder_.path(""));
  EXPECT_EQ(sequence.layout, "7-Scenes");
  EXPECT_THAT(sequence.remarks, IsEmpty());
  EXPECT_TRUE(sequence.has_poses);
  ASSERT_EQ(sequence.frames.size(), 3U);
  EXPECT_EQ(sequence.frames[2].stamp, 20);
  EXPECT_TRUE(loadPose(sequence.frames[2]).isApprox(posedAt(2), 1e-12));
  const RgbdCameras cameras = sequence.cameras();
  EXPECT_EQ(cameras.depth.fy, 20);
  EXPECT_EQ(cameras.meaning.scale, 1000);
  EXPECT_FALSE(cameras.color) << "its camera is not a Kinect";
  EXPECT_FALSE(open(withoutPoses()).has_poses);
}

TEST_F(RgbdFolders, OfTumAreListed)
{
  writeTum(folder_, 2);
  const RgbdSequence sequence = open();
  EXPECT_EQ(sequence.layout, "TUM");
  EXPECT_TRUE(sequence.is_registered);
  EXPECT_THAT(sequence.remarks,
              ElementsAre(HasSubstr("does not tell its camera"),
                          HasSubstr("scaled to the depth images' 8 x 6")));
  ASSERT_EQ(sequence.frames.size(), 2U);
  EXPECT_TRUE(loadPose(sequence.frames[1]).isApprox(posedAt(1), 1e-5));
  EXPECT_EQ(sequence.cameras().meaning.scale, 5000);
  RgbdSequenceSettings settings;
  settings.has_camera = true;
  EXPECT_THAT(open(settings).remarks, IsEmpty());
  settings.max_stamp_gap = 0.001;
  EXPECT_THROW(open(settings), EmptyInputException) << "colour is 4 ms later";
}

/** A matrix as Open3D writes its cameras. */
constexpr const char* open3d_camera = "{\n\t\"height\" : 6,\n\t\"intrinsic_matrix\" : "
                                      "\n\t[\n\t\t10.0,\n\t\t0.0,\n\t\t0.0,\n"
                                      "\t\t0.0,\n\t\t20.0,\n\t\t0.0,\n\t\t3.5,\n\t\t2."
                                      "5,\n\t\t1.0\n\t],\n\t\"width\" : 8\n}\n";

/** Frames without leading zeros, so that 10 is before 9 as text. */
void
writeOpen3d(const TemporaryFolder& folder, const std::string& colors, int frames)
{
  std::filesystem::create_directory(folder.path(colors));
  std::filesystem::create_directory(folder.path("depth"));
  std::string log;
  for (int frame = 0; frame < frames; ++frame) {
    const std::string name = "/" + std::to_string(frame) + ".png";
    folder.write(colors + name, textOfBytes(encodePng(tellingColors(frame))));
    folder.write("depth" + name,
                 depthPngBytes(small_width, small_height, tellingDepths(frame)));
    const std::string number = std::to_string(frame);
    log += number + "\t" + number + "\t" + std::to_string(frame + 1) + "\n" +
           matrixText(posedAt(frame).matrix());
  }
  folder.write("trajectory.log", log);
  folder.write("camera_intrinsic.json", open3d_camera);
}

TEST_F(RgbdFolders, OfOpen3dAreListed)
{
  writeOpen3d(folder_, "color", 12);
  const RgbdSequence sequence = open();
  EXPECT_EQ(sequence.layout, "Open3D");
  EXPECT_THAT(sequence.remarks, IsEmpty());
  EXPECT_TRUE(sequence.is_registered);
  ASSERT_EQ(sequence.frames.size(), 12U);
  EXPECT_TRUE(loadPose(sequence.frames[10]).isApprox(posedAt(10), 1e-12));
  const RgbdCameras cameras = sequence.cameras();
  EXPECT_EQ(cameras.depth.fx, 10);
  EXPECT_EQ(cameras.depth.fy, 20);
  EXPECT_EQ(cameras.depth.cx, 3.5);
  EXPECT_EQ(cameras.depth.cy, 2.5);
  const RgbdObservation seen = loadRgbdObservation(sequence.frames[10], cameras);
  float z = 0;
  std::memcpy(&z, &seen.cloud.data[5 * seen.cloud.point_step + 8], sizeof z);
  EXPECT_FLOAT_EQ(z, 0.001F * static_cast<float>(tellingDepths(10)[5]))
      << "millimetres";
}

TEST_F(RgbdFolders, OfOpen3dMayHaveGaps)
{
  writeOpen3d(folder_, "image", 4);
  std::filesystem::remove(folder_.path("image/1.png"));
  std::filesystem::remove(folder_.path("camera_intrinsic.json"));
  const RgbdSequence sequence = open();
  EXPECT_EQ(sequence.unmatched, 1U);
  ASSERT_EQ(sequence.frames.size(), 3U);
  // by the number before its matrix
  EXPECT_TRUE(loadPose(sequence.frames[1]).isApprox(posedAt(2), 1e-12));
  EXPECT_EQ(sequence.camera.fx, 525.0 * 8 / 640);
  EXPECT_THAT(sequence.remarks,
              ElementsAre(HasSubstr("took Open3D's"),
                          HasSubstr("scaled to the depth images' 8 x 6")));
}

TEST_F(RgbdFolders, OfOpen3dThatAreUglyAreRefused)
{
  writeOpen3d(folder_, "rgb", 2);
  const auto fault = [&] { return faultOf([&] { open(); }); };
  folder_.write("camera_intrinsic.json", R"({"intrinsic_matrix": [1, 2]})");
  EXPECT_THAT(fault(), HasSubstr("camera_intrinsic.json"));
  folder_.write("camera_intrinsic.json", open3d_camera);
  folder_.write("trajectory.log", "0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n");
  EXPECT_THAT(fault(), HasSubstr("trajectory.log: has 4 rows"));
  folder_.write("trajectory.log", "0 0 1\n1 0 0 0\n0 2 0 0\n0 0 1 0\n0 0 0 1\n");
  EXPECT_THAT(fault(), HasSubstr("line 2: is no rigid motion"));
  folder_.write("trajectory.log", "0 0 1\n1 0 0 0\n0 1 0\n0 0 1 0\n0 0 0 1\n");
  EXPECT_THAT(fault(), HasSubstr("line 3: has 3 numbers"));
  std::filesystem::remove(folder_.path("trajectory.log"));
  EXPECT_FALSE(open().has_poses);
  EXPECT_THAT(open().remarks, ElementsAre(HasSubstr("looked for trajectory.log")));
  EXPECT_EQ(open(withoutPoses()).frames.size(), 2U);
  std::filesystem::rename(folder_.path("rgb/1.png"), folder_.path("rgb/b.png"));
  std::filesystem::rename(folder_.path("rgb/0.png"), folder_.path("rgb/a.png"));
  EXPECT_EQ(open(withoutPoses()).frames[1].color, folder_.path("rgb/b.png"));
  std::filesystem::remove(folder_.path("rgb/a.png"));
  EXPECT_THAT(faultOf([&] { open(withoutPoses()); }), HasSubstr("whose names differ"));
}

TEST_F(RgbdFolders, AreRecognizedByTheirNames)
{
  EXPECT_FALSE(isRgbdFolder(folder_.path("")));
  EXPECT_FALSE(isRgbdFolder(folder_.path("nowhere")));
  EXPECT_THAT(faultOf([&] { open(); }), HasSubstr("looked for rgb.txt"));
  EXPECT_THROW(openRgbdSequence(folder_.path("nowhere")), InputFileException);
  std::filesystem::create_directory(folder_.path("color"));
  std::filesystem::create_directory(folder_.path("depth"));
  EXPECT_TRUE(isRgbdFolder(folder_.path(""))) << "Open3D's layout";
  EXPECT_THROW(open(), EmptyInputException);
  folder_.write("cloud.PCD", "");
  EXPECT_THAT(faultOf([&] { open(); }), HasSubstr("looked for rgb.txt"));
  writeSevenScenes(folder_, 1);
  EXPECT_TRUE(isRgbdFolder(folder_.path("")));
  EXPECT_EQ(faultOf([&] { open(); }), "no fault");
}

/** An opened folder of 7-Scenes with three frames. */
class RgbdObservations : public RgbdFolders {
protected:
  RgbdObservations()
  {
    writeSevenScenes(folder_, 3);
    recorded_ = open();
    cameras_ = recorded_.cameras();
  }

  ObservationSequence
  sequence() const
  {
    return {recorded_, cameras_, 1};
  }

  RgbdSequence recorded_;
  RgbdCameras cameras_;
};

TEST_F(RgbdObservations, HaveTheCloudsAndPosesOfTheFrames)
{
  const ObservationSequence observations = sequence();
  EXPECT_THAT(observations.names(),
              ElementsAre("observation_0000.pcd",
                          "observation_0001.pcd",
                          "observation_0002.pcd"));
  EXPECT_TRUE(observations.hasTrajectory());
  EXPECT_THAT(observations.remarks(), IsEmpty());
  EXPECT_EQ(observations.getNumberOfReads(), 0U) << "no image is read at once";
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const int frame = static_cast<int>(i);
    const PosedObservation seen = observations.load(i);
    EXPECT_EQ(observations.stamp(i), 10 * frame);
    EXPECT_THAT(seen.remarks, IsEmpty());
    EXPECT_TRUE(
        seen.T_map_camera.isApprox(posedAt(0).inverse() * posedAt(frame), 1e-12));
    EXPECT_TRUE(seen.file->cloud.data ==
                loadRgbdObservation(recorded_.frames[i], cameras_).cloud.data);
  }
  EXPECT_TRUE(observations.load(0).T_map_camera.matrix().isIdentity(0));
}

TEST_F(RgbdObservations, AreAsTheFilesOfTheImport)
{
  const ObservationSequence observations = sequence();
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const PosedObservation seen = observations.load(i);
    const std::string path = folder_.path(observations.name(i));
    saveObservation(path,
                    loadRgbdObservation(recorded_.frames[i], cameras_).cloud,
                    seen.T_map_camera);
    const PointCloudFile file = loadPointCloud(path);
    ASSERT_EQ(seen.file->cloud.fields.size(), file.cloud.fields.size());
    for (std::size_t field = 0; field < file.cloud.fields.size(); ++field) {
      EXPECT_EQ(seen.file->cloud.fields[field].name, file.cloud.fields[field].name);
      EXPECT_EQ(seen.file->cloud.fields[field].offset, file.cloud.fields[field].offset);
    }
    EXPECT_EQ(seen.file->cloud.width, file.cloud.width);
    EXPECT_EQ(seen.file->cloud.height, file.cloud.height);
    EXPECT_EQ(seen.file->cloud.is_dense, file.cloud.is_dense);
    EXPECT_TRUE(seen.file->cloud.data == file.cloud.data);
    EXPECT_LT((seen.file->sensor_origin - file.sensor_origin).norm(), 1e-6F);
    EXPECT_LT(seen.file->sensor_orientation.angularDistance(file.sensor_orientation),
              1e-3F);
  }
}

TEST_F(RgbdObservations, OfAColorCameraAreInItsFrame)
{
  cameras_.color = kinectColorCamera();
  const ObservationSequence observations = sequence();
  const Eigen::Isometry3d& T_depth_color = cameras_.color->T_depth_color;
  const Eigen::Isometry3d expected =
      (posedAt(0) * T_depth_color).inverse() * posedAt(2) * T_depth_color;
  EXPECT_TRUE(observations.load(0).T_map_camera.matrix().isIdentity(0));
  EXPECT_TRUE(observations.load(2).T_map_camera.isApprox(expected, 1e-12));
  EXPECT_TRUE(observations.load(2).file->cloud.data ==
              loadRgbdObservation(recorded_.frames[2], cameras_).cloud.data);
}

TEST_F(RgbdObservations, AreReadOnceByAllCopies)
{
  ObservationSequence observations = sequence();
  const ObservationSequence posed = observations.withPoses(
      {1, 2}, {{5, 6}, {Eigen::Isometry3d::Identity(), posedAt(1)}});
  for (int round = 0; round < 2; ++round)
    for (std::size_t i = 0; i < observations.size(); ++i)
      observations.load(i);
  EXPECT_EQ(posed.load(1).file, observations.load(2).file);
  EXPECT_EQ(posed.stamp(1), 6);
  EXPECT_EQ(observations.getNumberOfReads(), 3U);
  observations.setCacheSize(0);
  observations.load(0);
  EXPECT_EQ(posed.getNumberOfReads(), 4U);
}

TEST_F(RgbdObservations, ThatAreBrokenAreNamed)
{
  folder_.write("frame-000000.depth.png", "no image");
  std::filesystem::remove(folder_.path("frame-000010.color.png"));
  const ObservationSequence observations = sequence();
  EXPECT_THAT(faultOf([&] { observations.load(0); }), HasSubstr("frame-000000.depth"));
  EXPECT_THAT(faultOf([&] { observations.load(1); }), HasSubstr("frame-000010.color"));
  EXPECT_EQ(observations.getNumberOfReads(), 0U);
  EXPECT_NO_THROW(observations.load(2));
  EXPECT_EQ(observations.getNumberOfReads(), 1U);
}

TEST_F(RgbdObservations, OfAnotherSizeAreRefused)
{
  folder_.write("frame-000010.color.png",
                textOfBytes(encodePng(tellingColors(1, 2, 1))));
  folder_.write("frame-000010.depth.png", depthPngBytes(2, 1, {1000, 2000}));
  const ObservationSequence observations = sequence();
  EXPECT_NO_THROW(observations.load(0));
  EXPECT_THAT(faultOf([&] { observations.load(1); }),
              HasSubstr("has 2 x 1 pixels, the images before have 8 x 6 pixels"));
  EXPECT_NO_THROW(observations.load(2));
}

TEST_F(RgbdObservations, NeedThePosesThatTheFolderWasOpenedWith)
{
  folder_.write("frame-000010.pose.txt", "lost");
  EXPECT_THAT(faultOf([&] { sequence(); }), HasSubstr("frame-000010.pose.txt"));
  recorded_ = open(withoutPoses());
  const ObservationSequence observations = sequence();
  EXPECT_FALSE(observations.hasTrajectory());
  EXPECT_EQ(observations.stamp(2), 20);
  EXPECT_TRUE(observations.load(2).T_map_camera.matrix().isIdentity(0));
  EXPECT_THROW(observations.requireDifferent({posedAt(0), posedAt(0)}),
               InputFileException);
}

TEST_F(RgbdObservations, OfNoFrameAreRefused)
{
  recorded_.frames.clear();
  EXPECT_THROW(sequence(), BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
