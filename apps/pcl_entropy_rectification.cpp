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
