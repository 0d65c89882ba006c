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
    requireInput(options);
    std::optional<pcl::ObservationSequence> posed;
    if (options.log.empty())
      posed.emplace(options.folder, tool.scale());
    rectifyPoses(tool, options, posed);
    tool.setReportPlace(options.output + "/report.json");
  });
}
