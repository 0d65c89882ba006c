#include <pcl/segmentation/box_fitting.h>

#include "boxes/box_kernel.h"

#include <pcl/exceptions.h>

namespace pcl {

void
BoxFitting::segment(std::vector<BoxPatch>& boxes)
{
  if (!has_planes_)
    PCL_THROW_EXCEPTION(InitFailedException, "no planes were set");
  BoxFittingReport report;
  boxes = acmap::boxes::fitBoxes(planes_, acmap::Progress(progress_), report);
  report_ = std::move(report);
}

} // namespace pcl
