#include "digiclops_grabber/digiclops_camera.h"

int
main(int argc, char** argv)
{
  using namespace pcl::acmap;
  Tool tool(
      "pcl_digiclops_grabber",
      "Takes observations with a trinocular camera and a projector: point clouds, "
      "a raw session, or both.");
  DigiclopsOptions options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] {
    requireSense(tool, options);
    if (options.list)
      listDigiclopsCameras(tool.log());
    else
      grab(
          options,
          [&](const pcl::TrinocularRig& rig) {
            return openDigiclopsCamera(options, rig);
          },
          tool.controls(),
          tool.log());
  });
}
