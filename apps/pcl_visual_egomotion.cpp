#include "visual_egomotion/egomotion_options.h"

int
main(int argc, char** argv)
{
  using namespace pcl::acmap;
  Tool tool("pcl_visual_egomotion",
            "Tells where the camera was at each observation, from what it saw alone.");
  EgomotionOptions options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] {
    const pcl::ObservationSequence sequence =
        observationsOf(options, tool.reader().getScale());
    tool.requireReportWritable(sequence.paths());
    tool.setOutputFolder(options.output);
    estimatePoses(options, sequence, tool.controls(), tool.log());
  });
}
