#include "scene_text.h"

#include <pcl/simulation/ray_casting.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

/** Bytes are rejected, or give a scene that can be rendered. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const auto scene = pcl::acmap::readScene(pcl::acmap::parseYaml("input", text));
    pcl::TrinocularRig rig;
    rig.width = 16;
    rig.height = 12;
    rig.focal_length = 13;
    rig.center_x = 7.5;
    rig.center_y = 5.5;
    const auto image = pcl::castView(scene.geometry, rig, scene.views.front());
    for (const std::int32_t surface : image.surface)
      if (surface >= static_cast<std::int32_t>(scene.geometry.surfaces().size()))
        std::abort();
  }
  catch (const pcl::InputFileException&) {
    return 0;
  }
  return 0;
}
