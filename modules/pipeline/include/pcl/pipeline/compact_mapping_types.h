#pragma once

#include <pcl/core/report.h>
#include <pcl/egomotion/revisit_detection_types.h>
#include <pcl/mapping/entropy_rectification_types.h>
#include <pcl/mapping/map_levelling_types.h>
#include <pcl/mapping/plane_adjustment_types.h>
#include <pcl/pipeline/observation_merging.h>
#include <pcl/pipeline/plane_mapping_types.h>
#include <pcl/pipeline/sequence_consolidation.h>
#include <pcl/pipeline/visual_odometry.h>
#include <pcl/texture/texturing_types.h>

#include <optional>

namespace pcl {

/** \brief Report of CompactMapping on its last run; steps that did not run have no
 * report. Its seconds are those of the steps, its remarks those of all steps.
 * \ingroup pipeline */
struct CompactMappingReport : Report {
  MappingMode mode = MappingMode::Accurate; ///< as \ref CompactMapping::setMode set it
  std::optional<VisualOdometryResult> odometry; ///< if the poses were unknown
  std::optional<SequenceConsolidationReport> consolidation;
  std::optional<MapLevellingReport> levelling;
  std::optional<EntropyRectificationReport> rectification;
  std::optional<PlaneAdjustmentReport> adjustment; ///< if it was requested
  std::optional<RevisitReport> revisits; ///< of the adjustment, if there are images
  MergingReport merging;
  PlaneMappingReport planes;
  TexturingReport texture;
};

} // namespace pcl
