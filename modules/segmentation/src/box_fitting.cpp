#include <pcl/segmentation/box_fitting.h>

#include "boxes/box_kernel.h"

#include <pcl/core/exceptions.h>

namespace pcl {

void
BoxFitting::segment(std::vector<BoxPatch>& boxes)
{
  if (!has_planes_)
    throw acmap::InitFailed("no planes were set");
  BoxFittingReport report;
  boxes = acmap::boxes::fitBoxes(planes_, acmap::Progress(progress_), report);
  report_ = std::move(report);
}

} // namespace pcl
