#pragma once

#include "stage_log.h"

#include <pcl/egomotion/revisit_detection_types.h>
#include <pcl/mapping/plane_adjustment_types.h>

#include <optional>

namespace pcl::acmap {

/** \brief Reports an adjustment by planes: lines of the summary, and `adjustment` in the
 * details. */
void
tellAdjustment(const PlaneAdjustmentReport& report,
               const std::optional<RevisitReport>& revisits,
               StageLog& log);

} // namespace pcl::acmap
