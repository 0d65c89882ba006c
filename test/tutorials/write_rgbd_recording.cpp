#include "test_png.h"

#include <pcl/conversions.h>
#include <pcl/core/image_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/point_types.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

// Converts observation PCDs to a camera recording: a folder of colour and depth images
// in TUM's layout, with the rig.yaml of the observations.

namespace {

namespace fs = std::filesystem;
using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;

constexpr double depth_scale = 5000; // units per metre, as for TUM

void
writeColors(const std::string& path, const Cloud& cloud)
{
  pcl::RgbImage image{
      static_cast<int>(cloud.width), static_cast<int>(cloud.height), {}};
  for (const pcl::PointXYZRGB& point : cloud)
    image.values.insert(image.values.end(), {point.r, point.g, point.b});
  pcl::savePng(path, image);
}

void
writeDepths(const std::string& path, const Cloud& cloud)
{
  std::vector<std::uint16_t> depths;
  for (const pcl::PointXYZRGB& point : cloud)
    depths.push_back(std::isfinite(point.z) ? static_cast<std::uint16_t>(
                                                  std::lround(depth_scale * point.z))
                                            : std::uint16_t{0});
  std::ofstream(path, std::ios::binary)
      << pcl::acmap::test::depthPngBytes(cloud.width, cloud.height, depths);
}

void
writeRecording(const fs::path& observations, const fs::path& recording)
{
  fs::create_directories(recording / "rgb");
  fs::create_directories(recording / "depth");
  fs::copy_file(observations / "rig.yaml", recording / "rig.yaml");
  std::ofstream colors(recording / "rgb.txt"), depths(recording / "depth.txt");
  char name[32] = "";
  for (int i = 0;; ++i) {
    std::snprintf(name, sizeof name, "observation_%04d.pcd", i);
    if (!fs::exists(observations / name))
      return;
    Cloud cloud;
    pcl::fromPCLPointCloud2(pcl::loadPointCloud(observations / name).cloud, cloud);
    const std::string image = std::to_string(i) + ".png";
    writeColors(recording / "rgb" / image, cloud);
    writeDepths(recording / "depth" / image, cloud);
    colors << i << ".0 rgb/" << image << "\n";
    depths << i << ".0 depth/" << image << "\n";
  }
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 3) {
    std::cerr << "usage: write_rgbd_recording OBSERVATIONS RECORDING\n";
    return 2;
  }
  try {
    writeRecording(argv[1], argv[2]);
  }
  catch (const std::exception& exception) {
    std::cerr << "write_rgbd_recording: " << exception.what() << "\n";
    return 1;
  }
}
