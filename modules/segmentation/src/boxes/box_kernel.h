#pragma once

#include <pcl/core/box_patch.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/progress.h>
#include <pcl/segmentation/box_fitting_types.h>

#include <vector>

namespace pcl::acmap::boxes {

/** The kernel of BoxFitting, independent of PCL.
 * \param[out] report counts, seconds, remarks; it is reset first
 * \throws CancelledException when the progress callback requested to stop */
std::vector<BoxPatch>
fitBoxes(const std::vector<PlanePatch>& planes,
         const Progress& progress,
         BoxFittingReport& report);

} // namespace pcl::acmap::boxes
