#include "checks.h"
#include "rgbd/text_rows.h"

#include <pcl/core/impl/yaml_node.h>
#include <pcl/pipeline/rgbd_cameras.h>

using namespace pcl::acmap;

/** Bytes are rejected, or give a camera with a valid pose. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text = test::textOfInput(data, size);
  const auto camera =
      test::acceptedBy([&] { return readColorCamera(parseYaml("input", text)); });
  test::require(!camera || (camera->T_depth_color.matrix().allFinite() &&
                            isRotation(camera->T_depth_color.linear())));
  return 0;
}
