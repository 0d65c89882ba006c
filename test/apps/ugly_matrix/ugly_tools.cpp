#include "ugly_tools.h"

#include <algorithm>

namespace pcl::acmap::test {

std::vector<UglyTool>
uglyTools()
{
  std::vector<UglyTool> tools = {uglyActiveStereo(),
                                 uglyCameraGrabber(),
                                 uglyCompactMapping(),
                                 uglyCompactViewer(),
                                 uglyDewallSurface(),
                                 uglyDigiclopsGrabber(),
                                 uglyEntropyRectification(),
                                 uglyLinePattern(),
                                 uglyPaperFigures(),
                                 uglyPlaneExtraction(),
                                 uglyCloudInfo(),
                                 uglyPlaneTexturing(),
                                 uglyRgbdImport(),
                                 uglyRigCalibration(),
                                 uglySimulatedRig(),
                                 uglyVisualEgomotion()};
  for (UglyTool& tool : tools)
    std::stable_sort(
        tool.cases.begin(), tool.cases.end(), [](const UglyCase& a, const UglyCase& b) {
          return a.kind < b.kind;
        });
  return tools;
}

} // namespace pcl::acmap::test
