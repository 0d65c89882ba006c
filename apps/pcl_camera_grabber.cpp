#include "camera_grabber/video_cameras.h"

#include <cstdlib>

int
main(int argc, char** argv)
{
  using namespace pcl::acmap;
  // FFmpeg would print its own messages; its errors become those of the tool.
  constexpr const char* quiet = "-8";
  setenv("OPENCV_FFMPEG_LOGLEVEL", quiet, 0);
  Tool tool("pcl_camera_grabber",
            "Takes observations with two or three cameras, for example webcams, and a "
            "projector: point clouds, a raw session, or both.");
  CameraOptions options;
  addOptions(tool, options);
  tool.setHelp({{{"pcl_camera_grabber --list", "The cameras that are there."},
                 {"pcl_camera_grabber --device 0 2 --rig rig.yaml --pcd clouds",
                  "Observations of two cameras as point clouds."}},
                {}});
  return tool.run(argc, argv, [&] {
    requireSense(tool, options);
    if (options.list)
      listVideoCameras(tool.log());
    else
      grab(
          options,
          [&](const pcl::TrinocularRig& rig) { return openVideoCameras(options, rig); },
          tool.controls(),
          tool.log());
  });
}
