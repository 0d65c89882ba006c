#include "mcap_file.h"

#include <fstream>
#include <iostream>

/** Writes a bag as the tests read it, for readers of others: test/npm/check_bag.mjs. */
int
main(int argc, char** argv)
{
  using namespace pcl::acmap::test;
  if (argc != 3) {
    std::cerr << "usage: write_test_bag BAG.mcap none|lz4|zstd\n";
    return 2;
  }
  McapWriter bag(argv[2]);
  for (int frame = 0; frame < 3; ++frame) {
    const double stamp = 1700000000 + frame;
    bag.add("/camera/depth/image_raw",
            "sensor_msgs/msg/Image",
            stamp,
            imageMessage(stamp, "camera", 64, 48, "16UC1", std::string(6144, '\7')));
    bag.add("/camera/depth/camera_info",
            "sensor_msgs/msg/CameraInfo",
            stamp,
            cameraMessage(stamp, "camera", 64, 48, Eigen::Matrix3d::Identity()));
    bag.add("/tf",
            "tf2_msgs/msg/TFMessage",
            stamp,
            transformMessage(stamp, "map", "camera", Eigen::Isometry3d::Identity()));
    bag.endChunk();
  }
  std::ofstream(argv[1], std::ios::binary) << bag.finish();
}
