#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/ros_messages.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

using namespace pcl;

void
requireImage(std::size_t values, std::int32_t width, std::int32_t height)
{
  if (width <= 0 || height <= 0 ||
      values != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    std::abort();
}

void
readImage(const RosImage& image)
{
  if (image.isDepth()) {
    const DepthImage depth = depthsOf(image, "input");
    requireImage(depth.metres.size(), depth.width, depth.height);
    return;
  }
  const RgbImage color = colorsOf(image, "input");
  requireImage(color.values.size() / 3, color.width, color.height);
}

void
readCloud(std::string_view bytes, RosSerialization serialization)
{
  const PCLPointCloud2 cloud = readRosCloud(bytes, "input", serialization).cloud;
  if (cloud.data.size() != acmap::rowsOf(cloud) * cloud.point_step ||
      !acmap::findField(cloud, "x", PCLPointField::FLOAT32))
    std::abort();
}

void
requirePose(const Eigen::Isometry3d& pose)
{
  if (!pose.matrix().allFinite())
    std::abort();
}

} // namespace

/** The first byte chooses the message, and its highest bit the serialization. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0)
    return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    const auto serialization =
        data[0] < 128 ? RosSerialization::Cdr : RosSerialization::Ros1;
    switch (data[0] % 128 % 8) {
    case 0:
      readImage(readRosImage(bytes, "input", serialization));
      break;
    case 1:
      readImage(readRosCompressedImage(bytes, "input", serialization));
      break;
    case 2:
      readCloud(bytes, serialization);
      break;
    case 3:
      for (const RosTransform& transform :
           readRosTransforms(bytes, "input", serialization))
        requirePose(transform.T_parent_child);
      break;
    case 4:
      requirePose(readRosOdometry(bytes, "input", serialization).T_parent_child);
      break;
    case 5:
      if (data[0] % 16 == 5) {
        requirePose(readRosPose(bytes, "input", serialization).T_parent_child);
        break;
      }
      for (const RosTransform& pose : readRosPath(bytes, "input", serialization))
        requirePose(pose.T_parent_child);
      break;
    case 7:
      if (!std::isfinite(readRosScan(bytes, "input", serialization).angle_step))
        std::abort();
      break;
    default:
      if (!(readRosCameraInfo(bytes, "input", serialization).pinhole.fx > 0))
        std::abort();
    }
  }
  catch (const InputFileException&) {
    return 0;
  }
  return 0;
}
