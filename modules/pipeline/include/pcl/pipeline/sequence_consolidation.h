#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/report.h>
#include <pcl/core/stage_controls.h>
#include <pcl/core/trajectory.h>
#include <pcl/mapping/map_levelling.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace pcl {

/** \brief An observation that was consolidated on its own. \ingroup pipeline */
struct ConsolidatedObservation {
  /** \brief Consolidated points with normals, or raw points (\ref
   * SequenceConsolidation::setRawPoints); NaN where there is no normal; sensor frame,
   * metres. */
  PointCloud<PointNormal>::Ptr cloud;
  std::size_t points = 0;  ///< finite points of the observation
  double voxel_size = 0;   ///< metres; 0 if raw or without a point
  float weight = 1;        ///< of each point, in areas of the smallest voxel
  bool is_colored = false; ///< Does the observation have colours?
};

/** \brief Observations of a sequence, each consolidated on its own.
 * \ingroup pipeline */
struct ConsolidatedObservations {
  /** \brief Indices in the sequence of those that could be read. */
  std::vector<std::size_t> places;
  Trajectory trajectory; ///< T_map_camera of each observation

  /** \brief As \ref ConsolidatedObservation::cloud. */
  std::vector<PointCloud<PointNormal>::Ptr> clouds;

  /** \brief Surface area that each of these points represents, in units of the smallest
   * voxel; empty for raw points, which weigh the same. */
  std::vector<std::vector<float>> weights;
};

/** \brief Report of SequenceConsolidation on its last run. \ingroup pipeline */
struct SequenceConsolidationReport : Report {
  std::size_t points = 0;          ///< finite points of all observations
  std::size_t representatives = 0; ///< points of all consolidated clouds; 0 if raw
  double min_voxel_size = 0;       ///< metres; 0 if raw
  double max_voxel_size = 0;       ///< metres; 0 if raw
  bool colored = false;            ///< Does an observation have colours?
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const SequenceConsolidationReport& report, Visitor&& visit)
{
  visit({"points"}, report.points);
  visit({"representatives"}, report.representatives);
  visit({"least_voxel", "m"}, report.min_voxel_size);
  visit({"largest_voxel", "m"}, report.max_voxel_size);
  visit({"colored"}, report.colored);
}

/** \brief Consolidates each observation of a sequence on its own: the input of
 * \ref EntropyRectification.
 *
 * The voxel size is that of \ref acmap::automaticVoxel, at least 5 cm: smaller ones
 * would make the rectification slower, but the map not straighter.
 * \ingroup pipeline */
class ACMAP_EXPORT SequenceConsolidation
: public StageControls<SequenceConsolidationReport> {
public:
  /** \brief Leaves out observations that cannot be read, with a remark (default
   * false). */
  void
  setSkipBroken(bool skip)
  {
    skip_broken_ = skip;
  }

  /** \brief Takes the points as they were measured, as the paper does (default false):
   * nothing is consolidated. */
  void
  setRawPoints(bool raw)
  {
    raw_points_ = raw;
  }

  bool
  getRawPoints() const
  {
    return raw_points_;
  }

  /** \brief Consolidates one observation, of whatever pose.
   * \param[in] name for messages
   * \throws InputFileException if its points are too far apart to be in metres */
  ConsolidatedObservation
  consolidate(const PointCloudFile& observation, const std::string& name) const;

  /** \brief Gives what \ref consolidate returned for each observation of the sequence,
   * where that was done before, so that \ref compute need not read them (default:
   * none).
   * \param[in] observations one per observation of the sequence; empty for none */
  void
  setConsolidated(std::vector<ConsolidatedObservation> observations)
  {
    consolidated_ = std::move(observations);
  }

  /** \brief Reads and consolidates a sequence with poses.
   * \throws InputFileException if an observation cannot be read and none may be
   * skipped, none can be read, all poses are the same though there are several, or the
   * points of an observation are too far apart to be in metres
   * \throws CancelledException if the progress callback stopped it */
  void
  compute(const ObservationSequence& sequence, ConsolidatedObservations& result);

private:
  std::vector<ConsolidatedObservation> consolidated_;
  bool skip_broken_ = false;
  bool raw_points_ = false;
};

/** \brief Levels the map of consolidated observations: their poses are replaced.
 * \param[in] levelling settings; its observations are not used
 * \ingroup pipeline */
ACMAP_EXPORT MapLevellingReport
levelObservations(const MapLevelling<PointNormal>& levelling,
                  ConsolidatedObservations& observations,
                  unsigned int threads = 0);

} // namespace pcl
