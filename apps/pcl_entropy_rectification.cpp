#include "entropy_rectification/rectification_options.h"

int
main(int argc, char** argv)
{
  using namespace pcl::acmap;
  Tool tool("pcl_entropy_rectification",
            "Straightens a map: finds the poses under which its observations fit "
            "together best.");
  RectificationOptions options;
  addOptions(tool, options);
  tool.setHelp({{{"pcl_entropy_rectification clouds -o straight",
                  "Straightens a folder of posed point clouds."},
                 {"pcl_entropy_rectification --carmen robot.log -o straight",
                  "The same for the scans of a laser log."}},
                {}});
  return tool.run(argc, argv, [&] {
    if (options.input().empty())
      throw UsageError("POSED_DIR, BAG or --carmen LOG is needed");
    requireSense(tool, options);
    options.up = tool.reader().getUpDirection();
    tool.requireReportWritable({options.input()});
    tool.setOutputFolder(options.output);
    if (options.log.empty())
      rectifyPoses(options,
                   pcl::ObservationSequence(options.folder, tool.reader().getScale()),
                   tool.controls(),
                   tool.log());
    else
      rectifyScans(options, tool.controls(), tool.log());
  });
}
