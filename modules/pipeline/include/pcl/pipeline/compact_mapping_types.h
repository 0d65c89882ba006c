#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/fields.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/report.h>
#include <pcl/egomotion/revisit_detection_types.h>
#include <pcl/mapping/entropy_rectification_types.h>
#include <pcl/mapping/map_levelling_types.h>
#include <pcl/mapping/plane_adjustment_types.h>
#include <pcl/pipeline/camera_path.h>
#include <pcl/pipeline/map_quality.h>
#include <pcl/pipeline/next_positions.h>
#include <pcl/pipeline/observation_merging.h>
#include <pcl/pipeline/plane_mapping_types.h>
#include <pcl/pipeline/pose_convention_check.h>
#include <pcl/pipeline/sequence_alignment.h>
#include <pcl/pipeline/sequence_consolidation.h>
#include <pcl/pipeline/visual_odometry.h>
#include <pcl/texture/texturing_types.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace pcl {

/** \brief State of a CompactMapping that works while observations arrive.
 * \ingroup pipeline */
struct MappingState {
  std::size_t arrived = 0;   ///< observations that are complete
  std::size_t processed = 0; ///< of these, those whose disparities and motion are known

  /** \brief The thread that adds observations waits, because too many of them wait. */
  bool is_late = false;

  /** \brief Seconds for which the oldest observation that is not processed has been
   * complete. */
  double lag = 0;

  /** \brief The last one that was processed, camera frame, metres. */
  std::shared_ptr<const PointCloudFile> newest;

  /** \brief Poses of the processed ones, before rectification; empty where an
   * observation could not be joined to those before. */
  std::vector<std::optional<Eigen::Isometry3d>> poses;

  /** \brief Planes, without textures, and poses of the observations up to some seconds
   * ago, before rectification; null until there are any
   * (\ref CompactMapping::setProvisionalInterval). */
  std::shared_ptr<const CompactMap> provisional;
};

/** \brief Called with the state when an observation was processed, when a provisional map
 * was computed, and when observations begin to wait; from several threads, possibly at
 * the same time. \ingroup pipeline */
using MappingStateCallback = std::function<void(const MappingState&)>;

/** \brief Report of CompactMapping on its last run; steps that did not run have no
 * report. Its seconds are those of the steps, its remarks those of all steps.
 * \ingroup pipeline */
struct CompactMappingReport : Report {
  MappingMode mode = MappingMode::Accurate; ///< as \ref CompactMapping::setMode set it
  std::optional<PoseConventionReport> pose_convention; ///< if poses were recorded
  std::optional<CameraPathReport> path;                ///< if it was measured
  std::optional<VisualOdometryResult> odometry;        ///< if the poses were unknown
  std::optional<SequenceAlignmentReport> extension;    ///< of an earlier map
  std::optional<SequenceConsolidationReport> consolidation;
  std::optional<MapLevellingReport> levelling;
  std::optional<EntropyRectificationReport> rectification;
  std::optional<PlaneAdjustmentReport> adjustment; ///< if it was requested
  std::optional<RevisitReport> revisits; ///< of the adjustment, if there are images
  MergingReport merging;
  PlaneMappingReport planes;
  TexturingReport texture;
  std::optional<MapQualityReport> quality;           ///< of a map with planes
  std::optional<NextPositionsReport> next_positions; ///< the same
  std::size_t ranks = 1;                             ///< processes that made the map
  std::size_t rank_messages = 0; ///< that rank 0 has sent and received
  std::size_t rank_bytes = 0;    ///< of these messages
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const CompactMappingReport& report, Visitor&& visit)
{
  visit({"mode"}, acmap::Named{report.mode, acmap::mapping_mode_names});
  visit({"pose_convention"}, report.pose_convention);
  visit({"path"}, report.path);
  visit({"odometry"}, report.odometry);
  visit({"extension"}, report.extension);
  visit({"consolidation"}, report.consolidation);
  visit({"levelling"}, report.levelling);
  visit({"rectification"}, report.rectification);
  visit({"adjustment"}, report.adjustment);
  visit({"revisits"}, report.revisits);
  visit({"merging"}, report.merging);
  visit({"planes"}, report.planes);
  visit({"texture"}, report.texture);
  visit({"quality"}, report.quality);
  visit({"next_positions"}, report.next_positions);
  visit({"ranks"}, report.ranks);
  visit({"rank_messages"}, report.rank_messages);
  visit({"rank_bytes", "bytes"}, report.rank_bytes);
}

} // namespace pcl
