#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/ros_messages.h>

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
readCloud(std::string_view bytes)
{
  const PCLPointCloud2 cloud = readRosCloud(bytes, "input").cloud;
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

/** The first byte chooses the message. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0)
    return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    switch (data[0] % 7) {
    case 0:
      readImage(readRosImage(bytes, "input"));
      break;
    case 1:
      readImage(readRosCompressedImage(bytes, "input"));
      break;
    case 2:
      readCloud(bytes);
      break;
    case 3:
      for (const RosTransform& transform : readRosTransforms(bytes, "input"))
        requirePose(transform.T_parent_child);
      break;
    case 4:
      requirePose(readRosOdometry(bytes, "input").T_parent_child);
      break;
    case 5:
      requirePose(readRosPose(bytes, "input").T_parent_child);
      break;
    default:
      if (!(readRosCameraInfo(bytes, "input").pinhole.fx > 0))
        std::abort();
    }
  }
  catch (const InputFileException&) {
    return 0;
  }
  return 0;
}
