#pragma once

#include "shown.h"

#include <pcl/mapping/plane_adjustment_types.h>

namespace pcl::acmap::python {

/** \brief Converts the report of a plane adjustment to an acmap.Report. */
ReportObject
reportOfAdjustment(const PlaneAdjustmentReport& report);

} // namespace pcl::acmap::python
