#pragma once

#include "shown.h"

#include <pcl/pipeline/compact_mapping_types.h>

namespace pcl::acmap::python {

/** \brief Converts the report of a mapping to an acmap.Report: a part for each step. */
ReportObject
reportOfMapping(const CompactMappingReport& report);

} // namespace pcl::acmap::python
