#include "messages.h"
#include "temporary_folder.h"

#include <pcl/core/calibration_file.h>
#include <pcl/core/rig_cameras.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

// One pair in the words of everyone: 640 x 480, f = 500, the neighbour 0.12 m to the right.
const std::string kalibr = R"(cam0:
  camera_model: pinhole
  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]
  distortion_model: radtan
  intrinsics: [500.0, 500.0, 322.5, 238.25]
  resolution: [640, 480]
cam1:
  T_cn_cnm1:
  - [1.0, 0.0, 0.0, -0.12]
  - [0.0, 1.0, 0.0, 0.0]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
  camera_model: pinhole
  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]
  distortion_model: radtan
  intrinsics: [500.0, 500.0, 322.5, 238.25]
  resolution: [640, 480]
)";

std::string
cameraInfo(const std::string& name, const std::string& offset)
{
  return "image_width: 640\nimage_height: 480\ncamera_name: " + name + R"(
camera_matrix:
  rows: 3
  cols: 3
  data: [500, 0, 322.5, 0, 500, 238.25, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
projection_matrix:
  rows: 3
  cols: 4
  data: [500, 0, 322.5, )" +
         offset + ", 0, 500, 238.25, 0, 0, 0, 1, 0]\n";
}

const std::string opencv = R"(%YAML:1.0
---
cameraMatrix1: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 500, 0, 322.5, 0, 500, 238.25, 0, 0, 1 ]
distCoeffs1: !!opencv-matrix
   rows: 1
   cols: 5
   dt: d
   data: [ 0, 0, 0, 0, 0 ]
cameraMatrix2: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 500, 0, 322.5, 0, 500, 238.25, 0, 0, 1 ]
distCoeffs2: !!opencv-matrix
   rows: 1
   cols: 5
   dt: d
   data: [ 0, 0, 0, 0, 0 ]
R: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 1, 0, 0, 0, 1, 0, 0, 0, 1 ]
T: !!opencv-matrix
   rows: 3
   cols: 1
   dt: d
   data: [ -0.12, 0, 0 ]
)";

const std::string orb_slam = R"(%YAML:1.0

Camera.type: "PinHole"
Camera.fx: 500.0
Camera.fy: 500.0
Camera.cx: 322.5
Camera.cy: 238.25
Camera.k1: 0.0
Camera.width: 640
Camera.height: 480
Camera.bf: 60.0
DepthMapFactor: 5000.0
)";

const std::string kitti = R"(P0: 5.0e+02 0 3.225e+02 0 0 5.0e+02 2.3825e+02 0 0 0 1 0
P1: 5.0e+02 0 3.225e+02 -6.5e+01 0 5.0e+02 2.3825e+02 0 0 0 1 0
P2: 5.0e+02 0 3.225e+02 3.0e+01 0 5.0e+02 2.3825e+02 0 0 0 1 0
P3: 5.0e+02 0 3.225e+02 -3.0e+01 0 5.0e+02 2.3825e+02 0 0 0 1 0
Tr: 0 -1 0 0 0 0 -1 0 1 0 0 0
)";

const std::string middlebury = "cam0=[500 0 322.5; 0 500 238.25; 0 0 1]\n"
                               "cam1=[500 0 353.5; 0 500 238.25; 0 0 1]\n"
                               "doffs=31\nbaseline=120\nwidth=640\nheight=480\n"
                               "ndisp=70\n";

/** A section of ROS' ost.txt. */
std::string
ostText(const std::string& name, const std::string& offset)
{
  return "# oST version 5.0 parameters\n\n\n[image]\n\nwidth\n640\n\nheight\n480\n\n[" +
         name + R"(]

camera matrix
500.000000  0.000000 322.500000
0.000000 500.000000 238.250000
0.000000 0.000000 1.000000

distortion
0.000000 0.000000 0.000000 0.000000 0.000000

rectification
1.000000 0.000000 0.000000
0.000000 1.000000 0.000000
0.000000 0.000000 1.000000

projection
500.000000 0.000000 322.500000 )" +
         offset + R"(
0.000000 500.000000 238.250000 0.000000
0.000000 0.000000 1.000000 0.000000

)";
}

const std::string stella = R"(Camera:
  name: "pair"
  setup: "stereo"
  model: "perspective"
  fx: 500.0
  fy: 500.0
  cx: 322.5
  cy: 238.25
  k1: 0.0
  cols: 640
  rows: 480
  focal_x_baseline: 60.0
)";

const std::string camodocal = R"(%YAML:1.0
---
model_type: PINHOLE
camera_name: camera
image_width: 640
image_height: 480
distortion_parameters:
   k1: 0.0
   k2: 0.0
   p1: 0.0
   p2: 0.0
projection_parameters:
   fx: 500
   fy: 500
   cx: 322.5
   cy: 238.25
)";

RigImages
imagesOf(int width = 640, int height = 480)
{
  RigImages images;
  images.width = width;
  images.height = height;
  return images;
}

CalibratedRig
rigOfTexts(const std::vector<std::string>& texts, const RigImages& images = imagesOf())
{
  std::vector<Calibration> calibrations;
  std::vector<std::string> names;
  for (const std::string& text : texts) {
    names.push_back("file" + std::to_string(names.size()));
    calibrations.push_back(readCalibration(names.back(), text));
  }
  return rigOf(names, calibrations, images);
}

std::string
faultOf(const std::vector<std::string>& texts, const RigImages& images = imagesOf())
{
  return messageOf<InputFileException>([&] { rigOfTexts(texts, images); });
}

std::string
replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  if (at == std::string::npos)
    throw std::logic_error(from + " is not in the text");
  return text.replace(at, from.size(), to);
}

void
expectPair(const CalibratedRig& found)
{
  EXPECT_FALSE(found.cameras);
  EXPECT_EQ(found.rig.width, 640);
  EXPECT_EQ(found.rig.height, 480);
  EXPECT_NEAR(found.rig.focal_length, 500, 1e-9);
  EXPECT_NEAR(found.rig.center_x, 322.5, 1e-9);
  EXPECT_NEAR(found.rig.center_y, 238.25, 1e-9);
  EXPECT_NEAR(found.rig.baseline_horizontal, 0.12, 1e-9) << found.told;
  EXPECT_EQ(found.rig.baseline_vertical, 0);
}

TEST(CalibrationFile, AllKindsStateTheSamePair)
{
  const std::vector<std::vector<std::string>> pairs = {
      {kalibr},
      {cameraInfo("left", "0"), cameraInfo("right", "-60")},
      {cameraInfo("right", "-60")},
      {opencv},
      {orb_slam},
      {kitti},
      {ostText("left", "0"), ostText("right", "-60")},
      {ostText("narrow_stereo/left", "0") + ostText("narrow_stereo/right", "-60")},
      {stella},
      {replaced(replaced(orb_slam, "Camera.bf", "Camera.focal_x_baseline"),
                "DepthMapFactor",
                "depthmap_factor")},
      {R"({"fx": 500, "fy": 500, "cx": 322.5, "cy": 238.25, "baseline": 0.12})"},
      {"500 0 322.5 0 500 238.25 0 0 1\n0.12\n"},
      {"[500, 0, 322.5,\n 0, 500, 238.25,\n 0, 0, 1]\r\n0.12 # metres\n"},
      {"%YAML:1.0\n---\nwidth: 640\nheight: 480\nfocal_length: 500\ncenter_x: 322.5\n"
       "center_y: 238.25\nbaseline_horizontal: 0.12\nbaseline_vertical: 0\n"
       "disparity_sigma: 0.13\n"}};
  for (const std::vector<std::string>& texts : pairs) {
    SCOPED_TRACE(texts.front());
    expectPair(rigOfTexts(texts));
  }
  EXPECT_THAT(rigOfTexts({ostText("left", "0") + ostText("right", "-60")}).told,
              HasSubstr("OpenCV"));
}

/** OpenCV's sample stereo_calib writes intrinsics.yml and extrinsics.yml. */
TEST(CalibrationFile, OneCalibrationMayBeInTwoFiles)
{
  const TemporaryFolder folder;
  const std::size_t half = opencv.find("R:");
  const std::string intrinsics = folder.write("in.yml", opencv.substr(0, half));
  const std::string extrinsics =
      folder.write("ex.yml", "%YAML:1.0\n---\n" + opencv.substr(half));
  expectPair(loadRig({intrinsics, extrinsics}, imagesOf()));
  expectPair(loadRig({extrinsics, intrinsics}, imagesOf()));
  EXPECT_THAT(messageOf<InputFileException>([&] { loadRig({intrinsics}, imagesOf()); }),
              HasSubstr("EXTRINSICS"));
  EXPECT_THAT(messageOf<InputFileException>([&] {
                loadRig({intrinsics, folder.path("none")}, imagesOf());
              }),
              HasSubstr("none"));
}

TEST(CalibrationFile, OneCameraIsReadFromAllKinds)
{
  const TemporaryFolder folder;
  const std::vector<std::string> texts = {
      kalibr,
      cameraInfo("left", "0"),
      opencv,
      orb_slam,
      kitti,
      middlebury,
      ostText("camera", "0"),
      stella,
      camodocal,
      "500 500 322.5 238.25\n",
      "500 0 322.5 0\n0 500 238.25 0\n0 0 1 0\n0 0 0 1\n",
      R"({"width": 640, "height": 480,
          "intrinsic_matrix": [500, 0, 0, 0, 500, 0, 322.5, 238.25, 1]})",
      R"({"width": 640, "height": 480, "fx": 500, "fy": 500, "ppx": 322.5,
          "ppy": 238.25, "model": "distortion.brown_conrady", "coeffs": [0,0,0,0,0]})",
      R"({"camera": {"w": 640, "h": 480, "fx": 500, "fy": 500, "cx": 322.5,
          "cy": 238.25, "scale": 6553.5}})"};
  for (const std::string& text : texts) {
    SCOPED_TRACE(text);
    const std::string path = folder.write("camera", text);
    const CalibratedPinhole camera = loadCameraPinhole(path);
    EXPECT_EQ(camera.pinhole.fx, 500);
    EXPECT_EQ(camera.pinhole.fy, 500);
    EXPECT_EQ(camera.pinhole.cx, 322.5);
    EXPECT_EQ(camera.pinhole.cy, 238.25);
    if (camera.width == 0)
      continue;
    const Pinhole half = fittedPinhole(camera, 320, 240, path);
    EXPECT_EQ(half.fx, 250);
    EXPECT_EQ(half.cx, 161); // pixel centres: (322.5 + .5) / 2 - .5
    EXPECT_THAT(
        messageOf<InputFileException>([&] { fittedPinhole(camera, 640, 360, path); }),
        HasSubstr("another shape"));
  }
  EXPECT_EQ(loadCameraPinhole(folder.write("orb", orb_slam)).depth_scale, 5000);
}

TEST(CalibrationFile, PrincipalPointsMayDiffer)
{
  const CalibratedRig found = rigOfTexts({middlebury});
  EXPECT_FALSE(found.cameras);
  EXPECT_EQ(found.rig.center_x, 322.5);
  EXPECT_EQ(found.rig.center_x_horizontal, 353.5);
  EXPECT_NEAR(found.rig.baseline_horizontal, 0.12, 1e-12);
  EXPECT_EQ(disparityOffset(found.rig), 31);
  EXPECT_THAT(faultOf({replaced(middlebury, "doffs=31", "doffs=-31")}),
              HasSubstr("doffs"));
  const TemporaryFolder folder;
  saveTrinocularRig(folder.path("rig.yaml"), found.rig);
  EXPECT_EQ(loadTrinocularRig(folder.path("rig.yaml")).center_x_horizontal, 353.5);
  TrinocularRig three = found.rig;
  three.baseline_vertical = -0.1;
  EXPECT_THROW(requireSoundRig(three), BadArgumentException);
}

TEST(CalibrationFile, NeighbourOnTheLeft)
{
  EXPECT_NEAR(rigOfTexts({replaced(kalibr, "-0.12", "0.12")}).rig.baseline_horizontal,
              -0.12,
              1e-12);
  EXPECT_NEAR(rigOfTexts({cameraInfo("right", "-60"), cameraInfo("left", "0")})
                  .rig.baseline_horizontal,
              -0.12,
              1e-12);
  RigImages images = imagesOf();
  images.cameras = {"cam1", "cam0"};
  EXPECT_NEAR(rigOfTexts({kalibr}, images).rig.baseline_horizontal, -0.12, 1e-12);
}

TEST(CalibrationFile, UnrectifiedCamerasAreToBeRectified)
{
  const std::string lens = "distortion_coeffs: [-0.2, 0.05, 0.001, -0.001]";
  const std::string text =
      replaced(kalibr, "distortion_coeffs: [0.0, 0.0, 0.0, 0.0]", lens);
  const CalibratedRig found = rigOfTexts({text});
  ASSERT_TRUE(found.cameras);
  EXPECT_EQ(found.cameras->cameras[0].distortion[0], -0.2);
  EXPECT_NEAR(found.cameras->camera(RigCamera::Horizontal).T_reference_camera(0, 3),
              0.12,
              1e-12);
  RigImages images = imagesOf();
  images.are_raw = false;
  EXPECT_THAT(faultOf({text}, images), HasSubstr("as they are built only"));
  images.are_raw = true;
  EXPECT_THAT(faultOf({kitti}, images), HasSubstr("rectified cameras only"));
}

TEST(CalibrationFile, WhatMayBeEitherIsAsked)
{
  const std::string left =
      replaced(cameraInfo("left", "0"), "data: [0, 0,", "data: [-0.3, 0.1,");
  const std::string right =
      replaced(cameraInfo("right", "-60"), "data: [0, 0,", "data: [-0.3, 0.1,");
  EXPECT_THAT(faultOf({left, right}), HasSubstr("--rectified"));
  RigImages images = imagesOf();
  images.are_raw = false;
  expectPair(rigOfTexts({left, right}, images));
  images.are_raw = true;
  const CalibratedRig raw = rigOfTexts({left, right}, images);
  ASSERT_TRUE(raw.cameras);
  EXPECT_EQ(raw.cameras->cameras[0].distortion[0], -0.3);
}

TEST(CalibrationFile, OtherModelsAreRefusedByName)
{
  for (const std::string model : {"equidistant", "fov"})
    EXPECT_THAT(faultOf({replaced(kalibr, "radtan", model)}), HasSubstr(model));
  for (const std::string model : {"omni", "ds", "eucm"})
    EXPECT_THAT(faultOf({replaced(kalibr, "pinhole", model)}), HasSubstr(model));
  EXPECT_THAT(faultOf({replaced(camodocal, "PINHOLE", "KANNALA_BRANDT")}),
              HasSubstr("KANNALA_BRANDT"));
  EXPECT_THAT(faultOf({replaced(stella, "perspective", "fisheye")}),
              HasSubstr("fisheye"));
  EXPECT_THAT(faultOf({replaced(orb_slam, "PinHole", "KannalaBrandt8")}),
              HasSubstr("KannalaBrandt8"));
  EXPECT_THAT(faultOf({replaced(replaced(cameraInfo("left", "0"), "cols: 5", "cols: 8"),
                                "data: [0, 0, 0, 0, 0]",
                                "data: [0, 0, 0, 0, 0, 0.1, 0, 0]")}),
              HasSubstr("rational"));
}

TEST(CalibrationFile, UnitsAreAsked)
{
  EXPECT_THAT(faultOf({replaced(opencv, "-0.12", "-120")}),
              HasSubstr("--baseline 0.12"));
  EXPECT_THAT(faultOf({replaced(middlebury, "baseline=120", "baseline=0.12")}),
              HasSubstr("--baseline 0.12"));
  RigImages images = imagesOf();
  images.baseline = 0.12;
  expectPair(rigOfTexts({replaced(opencv, "-0.12", "-120")}, images));
  expectPair(rigOfTexts({"500 500 322.5 238.25\n"}, images));
  expectPair(rigOfTexts({camodocal, camodocal}, images));
}

TEST(CalibrationFile, ImagesOfAnotherSize)
{
  const CalibratedRig half = rigOfTexts({kalibr}, imagesOf(320, 240));
  EXPECT_EQ(half.rig.width, 320);
  EXPECT_EQ(half.rig.focal_length, 250);
  EXPECT_EQ(half.rig.center_x, 161);
  EXPECT_THAT(half.told, HasSubstr("scaled from 640 x 480"));
  EXPECT_THAT(faultOf({kalibr}, imagesOf(640, 360)), HasSubstr("another shape"));
  EXPECT_THAT(faultOf({opencv}, imagesOf(1280, 960)), HasSubstr("another size"));
  EXPECT_THAT(faultOf({opencv}, imagesOf(0, 0)), HasSubstr("does not state the size"));
}

TEST(CalibrationFile, FaultsAreNamed)
{
  EXPECT_THAT(faultOf({replaced(kalibr, "T_cn_cnm1", "T_cam_imu")}),
              HasSubstr("'T_cn_cnm1' is missing"));
  EXPECT_THAT(faultOf({replaced(kalibr, "intrinsics", "intrinsic")}),
              HasSubstr("'intrinsics' is missing"));
  EXPECT_THAT(faultOf({replaced(opencv, "\nT:", "\nTvector0:")}),
              HasSubstr("T, the translation"));
  EXPECT_THAT(faultOf({replaced(orb_slam, "Camera.cy", "Camera.c")}),
              HasSubstr("'Camera.cy' is missing"));
  EXPECT_THAT(faultOf({cameraInfo("left", "0")}), HasSubstr("--rig LEFT RIGHT"));
  EXPECT_THAT(faultOf({"500 500 322.5 238.25\n"}), HasSubstr("--baseline"));
  EXPECT_THAT(faultOf({"1 2 3\n"}), HasSubstr("has 3 numbers"));
  EXPECT_THAT(faultOf({"a: 1\n"}), HasSubstr("no calibration that is known"));
  EXPECT_THAT(faultOf({"[LEFT_CAM_HD]\nfx=500\nfy=500\n"}),
              HasSubstr("numbers alone, as fx fy cx cy"));
  EXPECT_THAT(faultOf({"<?xml version=\"1.0\"?><opencv_storage/>"}), HasSubstr("XML"));
  EXPECT_THAT(faultOf({replaced(kalibr, "500.0", ".nan")}), HasSubstr("'.nan'"));
  EXPECT_THAT(faultOf({replaced(kalibr, "500.0", "-500.0")}), HasSubstr("-500"));
  EXPECT_THAT(faultOf({replaced(kalibr, "[1.0, 0.0", "[2.0, 0.0")}),
              HasSubstr("no rotation"));
  EXPECT_THAT(faultOf({replaced(kitti, "P3: 5.0e+02", "P3: 6.0e+02")}),
              HasSubstr("rows differ"));
  RigImages images = imagesOf();
  images.cameras = {"cam0", "cam7"};
  EXPECT_THAT(faultOf({kalibr}, images), HasSubstr("'cam7'"));
}

TEST(CalibrationFile, KittisGreyPairIsThatOfGreyImages)
{
  RigImages images = imagesOf();
  images.are_grey = true;
  EXPECT_NEAR(rigOfTexts({kitti}, images).rig.baseline_horizontal, 0.13, 1e-12);
}

} // namespace
} // namespace pcl::acmap::test
