#include "room_views.h"
#include "test_data.h"

#include <pcl/conversions.h>
#include <pcl/core/image_file.h>
#include <pcl/egomotion/visual_egomotion.h>
#include <pcl/pipeline/rgbd_observation.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace pcl::acmap::test {
namespace {

const std::string folder = "C_sequence/redkitchen_000_495";

/** \brief A frame registered as by pcl_rgbd_import: in the frame of the colour
 * camera. */
struct RecordedView {
  PointCloud<PointXYZRGBSigma>::Ptr cloud{new PointCloud<PointXYZRGBSigma>};
  Eigen::Isometry3d T_world_camera;
};

RecordedView
observationOf(const RgbdSequence& sequence, int number)
{
  const auto frame = std::find_if(
      sequence.frames.begin(), sequence.frames.end(), [=](const RgbdFrame& other) {
        return static_cast<int>(other.stamp) == number;
      });
  const ColorCamera& camera = sequence.color_camera.value();
  RecordedView observation;
  fromPCLPointCloud2(
      registeredCloud(
          loadRgbImage(frame->color),
          measuredPoints(loadGrayImage16(frame->depth), sequence.camera, {}),
          camera),
      *observation.cloud);
  observation.T_world_camera = loadPose(*frame, sequence.cameras());
  return observation;
}

// The given poses have errors of about 1 cm and 0.3 degrees between such views.
TEST(VisualEgomotionReal, neighboursOfAKitchenAreNearTheirPoses)
{
  if (!hasTestData(folder + "/frame-000000.depth.png"))
    GTEST_SKIP() << "needs redkitchen of the test data";
  const RgbdSequence sequence = openRgbdSequence(testDataPath(folder).string());
  for (const int first : {0, 100, 250, 400}) {
    const RecordedView before = observationOf(sequence, first);
    const RecordedView now = observationOf(sequence, first + 10);
    VisualEgomotion<PointXYZRGBSigma> egomotion;
    egomotion.setMotionModel(MotionModel::Rigid);
    egomotion.setInputTarget(before.cloud);
    egomotion.setInputSource(now.cloud);
    const auto estimate = egomotion.compute();
    ASSERT_TRUE(estimate) << first << ": " << egomotion.getReport().reason;
    const Eigen::Matrix<double, 6, 1> error =
        motionBetween(before.T_world_camera.inverse() * now.T_world_camera,
                      estimate->T_target_source);
    EXPECT_LT(error.head<3>().norm(), 0.03) << first;
    EXPECT_LT(error.tail<3>().norm(), 1.5 / 57.3) << first;
    EXPECT_LT(egomotion.getReport().contradicted, 0.1) << first;
  }
}

} // namespace
} // namespace pcl::acmap::test
