#include "rendered_boards.h"
#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/random.h>
#include <pcl/stereo/rig_calibrator.h>
#include <pcl/stereo/trinocular_rectification.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

constexpr std::size_t shot_count = 18;

const std::vector<TrinocularFrame>&
shots()
{
  static const std::vector<TrinocularFrame> all = boardShots(builtRig(), shot_count);
  return all;
}

struct Calibrated {
  RigCalibrator calibrator;
  RigCalibration cameras;
  TrinocularRig rig;
};

void
addShots(const std::vector<TrinocularFrame>& frames, RigCalibrator& calibrator)
{
  for (std::size_t i = 0; i < frames.size(); ++i)
    calibrator.addShot(frames[i], shotNames(i));
}

const Calibrated&
calibrated()
{
  static const Calibrated result = [] {
    Calibrated made;
    addShots(shots(), made.calibrator);
    made.calibrator.calibrate(made.cameras, made.rig);
    return made;
  }();
  return result;
}

std::string
reasonOf(const RigCalibratorReport& report, const std::string& name)
{
  for (const BoardImage& image : report.images)
    if (image.name == name)
      return image.reason;
  return "no image of this name";
}

TEST(RigCalibrator, EpipolarResidualsAreSmall)
{
  const RigCalibratorReport& report = calibrated().calibrator.getReport();
  std::cout << "reprojection " << report.reprojection[0] << ", "
            << report.reprojection[1] << ", " << report.reprojection[2] << " px; rows "
            << report.row_residual << ", columns " << report.column_residual
            << " px; coverage " << report.coverage << "\n";
  EXPECT_GT(report.row_residual, 0.0);
  EXPECT_LE(report.row_residual, 0.15);
  EXPECT_GT(report.column_residual, 0.0);
  EXPECT_LE(report.column_residual, 0.15);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(report.boards[i], shot_count);
    EXPECT_LT(report.reprojection[i], 0.15);
  }
  for (const BoardImage& image : report.images) {
    EXPECT_EQ(image.reason, "") << image.name;
    EXPECT_GT(image.reprojection, 0.0) << image.name;
  }
}

TEST(RigCalibrator, CornersLieWhereTheBoardHasThem)
{
  const RigCalibration rig = builtRig();
  const std::vector<Eigen::Isometry3d> poses = boardPoses(shot_count);
  const RigCalibrator& calibrator = calibrated().calibrator;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < calibrator.getReport().images.size(); ++i) {
    const BoardImage& image = calibrator.getReport().images[i];
    const CameraCalibration& camera = rig.camera(image.camera);
    const auto& corners = calibrator.getCorners(i);
    ASSERT_EQ(corners.size(), 54u) << image.name;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Eigen::Vector3d corner(0.03 * double(k % 9), 0.03 * double(k / 9), 0);
      const Eigen::Vector2d truth = projectPoint(
          camera, camera.T_reference_camera.inverse() * poses[image.shot] * corner);
      sum += (corners[k].cast<double>() - truth).squaredNorm();
      ++count;
    }
  }
  const double rms = std::sqrt(sum / double(count));
  std::cout << "corners " << rms << " px off the truth\n";
  EXPECT_LT(rms, 0.15);
}

TEST(RigCalibrator, CamerasAreThoseThatWereBuilt)
{
  const RigCalibration truth = builtRig();
  for (std::size_t i = 0; i < 3; ++i) {
    const CameraCalibration& built = truth.cameras[i];
    const CameraCalibration& found = calibrated().cameras.cameras[i];
    const Eigen::Isometry3d off =
        built.T_reference_camera.inverse() * found.T_reference_camera;
    std::cout << "focal " << found.focal_x - built.focal_x << ", center "
              << found.center_x - built.center_x << " "
              << found.center_y - built.center_y << " px, place "
              << 1000 * off.translation().norm() << " mm, turn "
              << Eigen::AngleAxisd(off.linear()).angle() * 180 / M_PI << " deg\n";
    EXPECT_NEAR(found.focal_x, built.focal_x, 1.5);
    EXPECT_NEAR(found.focal_y, built.focal_y, 1.5);
    EXPECT_NEAR(found.distortion[0], built.distortion[0], 0.01);
    EXPECT_LT(off.translation().norm(), 5e-4);
    EXPECT_LT(Eigen::AngleAxisd(off.linear()).angle(), 0.15 * M_PI / 180);
  }
  EXPECT_NEAR(calibrated().rig.baseline_horizontal, -0.1, 2e-4);
  EXPECT_NEAR(calibrated().rig.baseline_vertical, -0.1, 2e-4);
}

/** \brief Tests points where no board was, all over the room and the image. */
TEST(RigCalibrator, RowsAndColumnsHoldAwayFromTheBoards)
{
  const RigCalibration built = builtRig();
  TrinocularRectification rectification;
  rectification.setInputCalibration(calibrated().cameras);
  double rows = 0;
  double columns = 0;
  std::size_t count = 0;
  for (double z = 0.8; z < 6.5; z *= 1.5)
    for (double x = -0.5; x < 0.51; x += 0.1)
      for (double y = -0.35; y < 0.36; y += 0.1) {
        const auto place = [&](RigCamera of) {
          const CameraCalibration& camera = built.camera(of);
          const Eigen::Vector3d point(x * z, y * z, z);
          return rectification.rectifiedPixel(
              of, projectPoint(camera, camera.T_reference_camera.inverse() * point));
        };
        const Eigen::Vector2d reference = place(RigCamera::Reference);
        rows += std::pow(place(RigCamera::Horizontal).y() - reference.y(), 2);
        columns += std::pow(place(RigCamera::Vertical).x() - reference.x(), 2);
        ++count;
      }
  rows = std::sqrt(rows / double(count));
  columns = std::sqrt(columns / double(count));
  std::cout << "by truth: rows " << rows << ", columns " << columns << " px\n";
  EXPECT_LT(rows, 0.15);
  EXPECT_LT(columns, 0.15);
}

TEST(RigCalibrator, SameShotsGiveTheSameCameras)
{
  RigCalibrator calibrator = calibrated().calibrator;
  RigCalibration first;
  RigCalibration second;
  TrinocularRig rig;
  calibrator.calibrate(first, rig);
  calibrator.calibrate(second, rig);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(first.cameras[i].focal_x, second.cameras[i].focal_x);
    EXPECT_EQ(first.cameras[i].T_reference_camera.matrix(),
              second.cameras[i].T_reference_camera.matrix());
  }
}

void
paint(CameraImage& image, int min_column, std::uint8_t value)
{
  for (std::size_t i = 0; i < image.values.size(); ++i)
    if (static_cast<int>(i) % image.width >= min_column)
      image.values[i] = value;
}

/** \brief Shifts the rows of an image by up to three pixels, which simulates a bent
 * board. */
void
wobble(CameraImage& image)
{
  for (int row = 0; row < image.height; ++row) {
    const auto begin = image.values.begin() + row * image.width;
    const auto shift = std::lround(1.5 + 1.5 * std::sin(row / 25.0));
    std::rotate(begin, begin + shift, begin + image.width);
  }
}

TEST(RigCalibrator, BadBoardsAreLeftOutByName)
{
  std::vector<TrinocularFrame> bad(shots().begin(), shots().begin() + 14);
  paint(bad[1].image(RigCamera::Vertical), 0, 120);     // board removed
  paint(bad[2].image(RigCamera::Horizontal), 300, 120); // half occluded
  bad[3].image(RigCamera::Vertical) = bad[9].image(RigCamera::Vertical);
  paint(bad[4].image(RigCamera::Reference), 0, 120);
  bad[5].image(RigCamera::Horizontal).width = 320;
  bad[5].image(RigCamera::Horizontal).values.resize(320 * 480);
  spoil(bad[6].image(RigCamera::Reference), 3.0, 2.0, 1);
  bad[7].image(RigCamera::Horizontal).values.clear();
  wobble(bad[8].image(RigCamera::Horizontal));
  Eigen::Isometry3d far = boardPoses(1).front();
  far.translation() *= 2.2 / far.translation().z();
  bad[10].image(RigCamera::Vertical) =
      RigRenderer(builtRig()).frameOf(far, boardBrightness).image(RigCamera::Vertical);
  RigCalibrator calibrator;
  addShots(bad, calibrator);
  RigCalibration cameras;
  TrinocularRig rig;
  calibrator.calibrate(cameras, rig);
  const RigCalibratorReport& report = calibrator.getReport();
  const auto expect = [&](const std::string& name, const std::string& word) {
    EXPECT_THAT(reasonOf(report, name), HasSubstr(word)) << name;
  };
  expect("vertical_01.png", "no whole board of 9 x 6 corners");
  expect("horizontal_02.png", "no whole board of 9 x 6 corners");
  expect("vertical_03.png", "does not fit the reference's image of this shot");
  expect("reference_04.png", "no whole board");
  expect("horizontal_04.png", "the reference has no good image");
  expect("vertical_04.png", "the reference has no good image");
  expect("horizontal_05.png", "320 x 480 pixels");
  expect("reference_06.png", "blurred");
  expect("horizontal_07.png", "no image of this name");
  expect("horizontal_08.png", "outlier: ");
  expect("vertical_10.png", "too small");
  std::size_t left_out = 0;
  for (const BoardImage& image : report.images)
    left_out += image.reason.empty() ? 0 : 1;
  EXPECT_EQ(left_out, 12u);
  EXPECT_LE(report.row_residual, 0.15);
  EXPECT_LE(report.column_residual, 0.15);
}

TEST(RigCalibrator, FewBoardsAndBareCornersAreTold)
{
  RigCalibrator calibrator;
  addShots({shots().begin(), shots().begin() + 8}, calibrator);
  RigCalibration cameras;
  TrinocularRig rig;
  calibrator.calibrate(cameras, rig);
  const RigCalibratorReport& report = calibrator.getReport();
  const auto tells = [&](const std::string& what) {
    return std::count_if(
        report.remarks.begin(), report.remarks.end(), [&](const std::string& remark) {
          return remark.find(what) != std::string::npos;
        });
  };
  EXPECT_EQ(tells("has only 8 good boards"), 3);
  EXPECT_EQ(tells("the boards cover only"), report.coverage < 0.4 ? 1 : 0);
  EXPECT_EQ(tells("are off by"), 0);
  for (const std::string& remark : calibrated().calibrator.getReport().remarks)
    EXPECT_EQ(remark.find("good boards"), std::string::npos) << remark;
}

TEST(RigCalibrator, TooFewBoardsAreNamed)
{
  RigCalibrator calibrator;
  RigCalibration cameras;
  TrinocularRig rig;
  EXPECT_THROW(calibrator.calibrate(cameras, rig), InitFailedException);
  addShots({shots().begin(), shots().begin() + 4}, calibrator);
  EXPECT_THAT([&] { calibrator.calibrate(cameras, rig); },
              testing::ThrowsMessage<InitFailedException>(
                  HasSubstr("reference camera has 4 good boards")))
      << "four boards were enough";
  EXPECT_FALSE(cameras.camera(RigCamera::Reference).is_there);
}

TEST(RigCalibrator, ImagesOfAnySizeAreLookedAt)
{
  Random random(3);
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{
           {1, 1}, {2, 3}, {9, 9}, {40, 30}, {3000, 1}, {1, 3000}}) {
    TrinocularFrame frame;
    CameraImage& image = frame.image(RigCamera::Reference);
    image = {width, height, 3, {}};
    for (int i = 0; i < 3 * width * height; ++i)
      image.values.push_back(static_cast<std::uint8_t>(random.bits()));
    RigCalibrator calibrator;
    calibrator.addShot(frame, shotNames(0));
    ASSERT_EQ(calibrator.getReport().images.size(), 1u);
    EXPECT_THAT(calibrator.getReport().images[0].reason, HasSubstr("no whole board"))
        << width << " x " << height;
  }
}

TEST(RigCalibrator, BoardsHeldAlikeTellNoFocalLength)
{
  RigCalibrator calibrator;
  for (std::size_t i = 0; i < 6; ++i)
    calibrator.addShot(shots().front(), shotNames(i));
  RigCalibration cameras;
  TrinocularRig rig;
  EXPECT_THAT([&] { calibrator.calibrate(cameras, rig); },
              testing::ThrowsMessage<InitFailedException>(HasSubstr("different tilts")))
      << "one place six times was enough";
}

TEST(RigCalibrator, OpenCvReadsTheFile)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("rig.yaml");
  saveRigCalibration(path, calibrated().rig, calibrated().cameras);
  const cv::FileStorage file(path, cv::FileStorage::READ);
  ASSERT_TRUE(file.isOpened());
  EXPECT_EQ(static_cast<double>(file["focal_length"]), calibrated().rig.focal_length);
  const cv::FileNode camera = file["camera_vertical"];
  const CameraCalibration& found = calibrated().cameras.camera(RigCamera::Vertical);
  const cv::Mat matrix = camera["camera_matrix"].mat();
  const cv::Mat pose = camera["pose"].mat();
  EXPECT_EQ(matrix.at<double>(0, 0), found.focal_x);
  EXPECT_EQ(matrix.at<double>(1, 2), found.center_y);
  EXPECT_EQ(camera["distortion"].mat().at<double>(0, 1), found.distortion[1]);
  EXPECT_EQ(pose.at<double>(1, 3), found.T_reference_camera(1, 3));
}

TEST(RigCalibrator, BoardsThatAreNoneAreRefused)
{
  RigCalibrator calibrator;
  const double nan = std::nan("");
  for (const CalibrationBoard& board : std::vector<CalibrationBoard>{{9, 7, 0.03},
                                                                     {8, 6, 0.03},
                                                                     {2, 5, 0.03},
                                                                     {9, 6, 0},
                                                                     {9, 6, nan},
                                                                     {9, 1000, 1}})
    EXPECT_THROW(calibrator.setBoard(board), BadArgumentException);
  TrinocularFrame frame = shots().front();
  frame.image(RigCamera::Vertical).values.pop_back();
  EXPECT_THROW(calibrator.addShot(frame, shotNames(0)), BadArgumentException);
  EXPECT_TRUE(calibrator.getReport().images.empty());
}

} // namespace
} // namespace pcl::acmap::test
