#include "active_stereo/stereo_options.h"

int
main(int argc, char** argv)
{
  using namespace pcl::acmap;
  Tool tool("pcl_active_stereo",
            "Turns what a trinocular rig saw under patterns into observation point "
            "clouds.");
  StereoOptions options;
  addOptions(tool, options);
  tool.setHelp({{{"pcl_active_stereo session -o clouds",
                  "One point cloud for each observation of a raw session."},
                 {"pcl_active_stereo --reference right.png --horizontal left.png --rig "
                  "rig.yaml -o clouds",
                  "One observation of images."}},
                {}});
  return tool.run(argc, argv, [&] {
    requireSense(tool, options);
    makeObservations(options, tool.controls(), tool.log());
  });
}
