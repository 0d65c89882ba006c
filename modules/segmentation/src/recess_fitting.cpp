#include <pcl/segmentation/recess_fitting.h>

#include "recesses/recess_kernel.h"

#include <pcl/core/exceptions.h>

namespace pcl {

void
RecessFitting::segment(std::vector<RecessPatch>& recesses)
{
  if (!has_planes_)
    throw acmap::InitFailed("no planes were set");
  RecessFittingReport report;
  recesses = acmap::recesses::fitRecesses(planes_, acmap::Progress(progress_), report);
  report_ = std::move(report);
}

} // namespace pcl
