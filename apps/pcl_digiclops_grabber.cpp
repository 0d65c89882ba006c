#include "digiclops_grabber/grabber_options.h"

int
main(int argc, char** argv)
{
  using namespace pcl::acmap;
  Tool tool(
      "pcl_digiclops_grabber",
      "Takes observations with a trinocular camera and a projector: point clouds, "
      "a raw session, or both.");
  GrabberOptions options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] {
    requireSense(tool, options);
    if (options.list)
      listCameras(tool.log());
    else
      grab(options, tool.controls(), tool.log());
  });
}
