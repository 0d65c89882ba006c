#pragma once

#include <pcl/core/plane_patch.h>
#include <pcl/core/progress.h>
#include <pcl/core/recess_patch.h>
#include <pcl/segmentation/recess_fitting_types.h>

#include <vector>

namespace pcl::acmap::recesses {

/** The kernel of RecessFitting, independent of PCL.
 * \param[out] report counts, seconds, remarks; it is reset first
 * \throws CancelledException when the progress callback requested to stop */
std::vector<RecessPatch>
fitRecesses(const std::vector<PlanePatch>& planes,
            const Progress& progress,
            RecessFittingReport& report);

} // namespace pcl::acmap::recesses
