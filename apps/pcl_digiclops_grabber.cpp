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
  tool.setHelp({{{"pcl_digiclops_grabber --list", "The cameras that are there."},
                 {"pcl_digiclops_grabber -o session", "Records a raw session."},
                 {"pcl_digiclops_grabber --device session --pcd clouds",
                  "Point clouds of a recorded one."}},
                {}});
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
