#include "messages.h"
#include "rgbd_folders.h"
#include "temporary_folder.h"
#include "test_png.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/rgbd_observation.h>

#include <gmock/gmock.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

constexpr Pinhole camera = {10, 20, 3.5, 2.5};

std::string
faultOf(const RgbdFrame& frame,
        const RgbdCameras& cameras,
        const RgbdImageSizes& sizes = {})
{
  return messageOf<InputFileException>(
      [&] { loadRgbdObservation(frame, cameras, sizes); }, "no fault");
}

/** A folder of 7-Scenes with one frame of 8 x 6 pixels. */
class RgbdImages : public testing::Test {
protected:
  RgbdImages()
  {
    writeSevenScenes(folder_, 1);
    frame_ = openRgbdSequence(folder_.path("")).frames.front();
    cameras_.depth = camera;
  }

  /** Replaces the depth image by one of another size. */
  void
  shrinkDepth() const
  {
    folder_.write("frame-000000.depth.png",
                  depthPngBytes(2, 2, {1000, 2000, 3000, 4000}));
  }

  TemporaryFolder folder_;
  RgbdFrame frame_;
  RgbdCameras cameras_;
};

TEST(RgbdPoints, AreThoseOfThePinhole)
{
  const GrayImage16 depth{2, 2, {0, 65535, 3000, 4001}};
  const auto points = measuredPoints(depth, {10, 20, 0.5, 3}, {1000, 4});
  ASSERT_EQ(points.size(), 4U);
  EXPECT_TRUE(std::isnan(points[0].z())) << "0: nothing was measured";
  EXPECT_TRUE(std::isnan(points[1].z())) << "65535: nothing was measured";
  EXPECT_TRUE(points[2].isApprox(Eigen::Vector3f(-0.15F, -0.3F, 3.0F)));
  EXPECT_TRUE(std::isnan(points[3].z())) << "beyond the maximum depth";
}

TEST(RgbdPoints, OfWrongArgumentsAreRefused)
{
  const GrayImage16 depth{2, 2, {1, 2, 3, 4}};
  EXPECT_THROW(measuredPoints({2, 2, {1, 2, 3}}, camera, {}), BadArgumentException);
  EXPECT_THROW(measuredPoints({0, 2, {}}, camera, {}), BadArgumentException);
  EXPECT_THROW(measuredPoints(depth, {}, {}), BadArgumentException);
  EXPECT_THROW(measuredPoints(depth, camera, {0, 0}), BadArgumentException);
  const RgbImage color{2, 1, {1, 2, 3, 4, 5, 6}};
  const auto points = measuredPoints(depth, camera, {});
  EXPECT_THROW(observationCloud(color, points), BadArgumentException);
  EXPECT_THROW(observationCloud({2, 2, {1, 2}}, points), BadArgumentException);
  EXPECT_THROW(registeredCloud({2, 2, {1, 2}}, points, kinectColorCamera()),
               BadArgumentException);
  EXPECT_THROW(registeredCloud(color, points, {{}, Eigen::Isometry3d::Identity()}),
               BadArgumentException);
  EXPECT_EQ(registeredCloud(color, points, kinectColorCamera()).width, 2U);
}

TEST_F(RgbdImages, AreOneObservation)
{
  const RgbdObservation observation = loadRgbdObservation(frame_, cameras_);
  EXPECT_EQ(observation.sizes.color.width, small_width);
  EXPECT_EQ(observation.sizes.depth.height, small_height);
  EXPECT_FALSE(observation.is_refined);
  const PCLPointCloud2 expected =
      observationCloud(loadRgbImage(frame_.color),
                       measuredPoints(loadGrayImage16(frame_.depth), camera, {}));
  EXPECT_EQ(observation.cloud.fields.size(), 5U);
  EXPECT_EQ(observation.cloud.width, 8U);
  EXPECT_TRUE(observation.cloud.data == expected.data);
}

TEST_F(RgbdImages, AreRefinedAsTheSensorRequires)
{
  cameras_.sensor = DepthSensor::Quantised;
  EXPECT_THROW(loadRgbdObservation(frame_, cameras_), UnorganizedPointCloudException)
      << "too few points for an image";
}

TEST_F(RgbdImages, OfTwoSizesNeedAColorCamera)
{
  shrinkDepth();
  EXPECT_THAT(faultOf(frame_, cameras_),
              HasSubstr("frame-000000.depth.png: has 2 x 2 pixels, the images before "
                        "have 8 x 6 pixels"));
  cameras_.color = kinectColorCamera();
  const RgbdObservation observation = loadRgbdObservation(frame_, cameras_);
  EXPECT_EQ(observation.cloud.width, 8U);
  EXPECT_EQ(observation.sizes.depth.width, 2);
  EXPECT_THAT(faultOf(frame_, cameras_, {{8, 6}, {8, 6}}), HasSubstr("depth.png: has"));
  EXPECT_THAT(faultOf(frame_, cameras_, {{6, 8}, {2, 2}}), HasSubstr("color.png: has"));
  EXPECT_EQ(faultOf(frame_, cameras_, {{8, 6}, {2, 2}}), "no fault");
}

TEST_F(RgbdImages, HaveThePoseOfTheCameraThatSawThem)
{
  EXPECT_TRUE(loadPose(frame_).isApprox(posedAt(0), 1e-12));
  EXPECT_TRUE(loadPose(frame_, cameras_).isApprox(posedAt(0), 1e-12));
  cameras_.color = kinectColorCamera();
  EXPECT_TRUE(loadPose(frame_, cameras_)
                  .isApprox(posedAt(0) * kinectColorCamera().T_depth_color, 1e-12));
}

} // namespace
} // namespace pcl::acmap::test
