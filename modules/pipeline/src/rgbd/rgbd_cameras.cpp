#include "rgbd/text_rows.h"

#include <pcl/core/calibration_file.h>
#include <pcl/core/file_format.h>
#include <pcl/core/impl/yaml_node.h>
#include <pcl/pipeline/rgbd_cameras.h>

#include <cmath>

namespace pcl {

namespace acmap {

namespace {

constexpr double max_pixels = 1e6;
constexpr double max_distance = 10.0; // metres, between two cameras in one device

Pinhole
pinholeOf(const YamlNode& camera)
{
  const auto focalLength = [&](const char* key) {
    return camera.at(key).number(1.0, max_pixels);
  };
  const bool is_one = camera.find("focal_length") != nullptr;
  for (const char* key : {"focal_length_x", "focal_length_y"})
    if (const YamlNode* other = camera.find(key); is_one && other)
      other->fail("stands beside focal_length, which is both");
  return {focalLength(is_one ? "focal_length" : "focal_length_x"),
          focalLength(is_one ? "focal_length" : "focal_length_y"),
          camera.at("center_x").number(-max_pixels, max_pixels),
          camera.at("center_y").number(-max_pixels, max_pixels)};
}

Eigen::RowVector3d
threeNumbersOf(const YamlNode& node, double maximum)
{
  Eigen::RowVector3d numbers;
  const std::vector<YamlNode>& list = node.list(3, 3);
  for (std::size_t i = 0; i < 3; ++i)
    numbers[static_cast<Eigen::Index>(i)] = list[i].number(-maximum, maximum);
  return numbers;
}

Eigen::Isometry3d
poseOf(const YamlNode& camera)
{
  const YamlNode& rows = camera.at("rotation");
  Eigen::Matrix3d rotation;
  for (std::size_t i = 0; i < 3; ++i)
    rotation.row(static_cast<Eigen::Index>(i)) =
        threeNumbersOf(rows.list(3, 3)[i], 1.0 + text_slack);
  if (!isRotation(rotation))
    rows.fail("is no rotation");
  Eigen::Isometry3d pose(Eigen::Quaterniond(rotation).normalized());
  pose.translation() = threeNumbersOf(camera.at("position"), max_distance).transpose();
  return pose;
}

} // namespace

ColorCamera
readColorCamera(const YamlNode& camera)
{
  requireFormat(camera, file_formats::camera);
  camera.requireKeys({"format",
                      "focal_length",
                      "focal_length_x",
                      "focal_length_y",
                      "center_x",
                      "center_y",
                      "position",
                      "rotation"});
  return {pinholeOf(camera), poseOf(camera)};
}

} // namespace acmap

Pinhole
loadPinhole(const std::string& path)
{
  return loadCameraPinhole(path).pinhole;
}

ColorCamera
kinectColorCamera()
{
  Eigen::Matrix3d rotation;
  rotation << 0.99996518, 0.00267651, -0.00790410, //
      -0.00274093, 0.99996303, -0.00815045,        //
      0.00788199, 0.00817183, 0.99993554;
  Eigen::Isometry3d T_color_depth(Eigen::Quaterniond(rotation).normalized());
  T_color_depth.translation() << -0.025559, 0.000101, 0.002032;
  return {{525.0, 525.0, 320.0, 240.0}, T_color_depth.inverse()};
}

ColorCamera
loadColorCamera(const std::string& path)
{
  return acmap::readColorCamera(acmap::loadYaml(path));
}

} // namespace pcl
