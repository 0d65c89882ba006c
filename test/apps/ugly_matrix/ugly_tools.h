#pragma once

#include "ugly_case.h"

namespace pcl::acmap::test {

/** \name Cases of each tool
 * \{ */
UglyTool
uglyDewallSurface();

UglyTool
uglyPlaneExtraction();

UglyTool
uglyCloudInfo();

UglyTool
uglyCompactViewer();

UglyTool
uglyEntropyRectification();

UglyTool
uglyVisualEgomotion();

UglyTool
uglyCameraGrabber();

UglyTool
uglyCompactMapping();

UglyTool
uglyActiveStereo();

UglyTool
uglyDigiclopsGrabber();

UglyTool
uglyRgbdImport();

UglyTool
uglyRigCalibration();

UglyTool
uglyLinePattern();

UglyTool
uglySimulatedRig();

UglyTool
uglyPlaneTexturing();

UglyTool
uglyPaperFigures();
/** \} */

} // namespace pcl::acmap::test
