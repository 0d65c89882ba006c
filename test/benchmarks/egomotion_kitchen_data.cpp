#include "egomotion_input.h"

#include "test_data.h"

#include <pcl/conversions.h>
#include <pcl/core/image_file.h>
#include <pcl/pipeline/rgbd_observation.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <iostream>

namespace pcl::acmap::bench {

std::optional<EgomotionSequence>
loadKitchen()
{
  const std::string folder = "C_sequence/redkitchen_000_495";
  if (!test::hasTestData(folder + "/frame-000000.pose.txt")) {
    std::cout << "\nkitchen: left out, no " << folder << "\n";
    return std::nullopt;
  }
  const RgbdSequence recorded = openRgbdSequence(test::testDataPath(folder).string());
  const ColorCamera& camera = recorded.color_camera.value();
  EgomotionSequence kitchen;
  kitchen.name = "redkitchen";
  kitchen.camera.focal_length = camera.pinhole.fx;
  kitchen.camera.center_x = camera.pinhole.cx;
  kitchen.camera.center_y = camera.pinhole.cy;
  for (const RgbdFrame& frame : recorded.frames) {
    const auto cloud = std::make_shared<EgomotionCloud>();
    fromPCLPointCloud2(
        registeredCloud(
            loadRgbImage(frame.color),
            measuredPoints(loadGrayImage16(frame.depth), recorded.camera, {}),
            camera),
        *cloud);
    kitchen.clouds.push_back(cloud);
    kitchen.truth.push_back(loadPose(frame, recorded.cameras()));
  }
  return kitchen;
}

} // namespace pcl::acmap::bench
