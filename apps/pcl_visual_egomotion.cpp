#include "visual_egomotion/egomotion_options.h"

int
main(int argc, char** argv)
{
  using namespace pcl::acmap;
  Tool tool("pcl_visual_egomotion",
            "Tells where the camera was at each observation, from what it saw alone.");
  EgomotionOptions options;
  addOptions(tool, options);
  tool.setHelp({{{"pcl_visual_egomotion clouds -o posed",
                  "Poses of a folder of organized point clouds."},
                 {"pcl_visual_egomotion a.pcd b.pcd -o posed --6dof",
                  "The motion between two views of a camera in a hand."}},
                {}});
  return tool.run(argc, argv, [&] {
    const pcl::ObservationSequence sequence =
        observationsOf(options, tool.reader().getScale());
    tool.requireReportWritable(sequence.paths());
    tool.setOutputFolder(options.output);
    estimatePoses(options, sequence, tool.controls(), tool.log());
  });
}
