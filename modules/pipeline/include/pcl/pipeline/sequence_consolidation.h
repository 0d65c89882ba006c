#pragma once

#include <pcl/core/export.h>
#include <pcl/core/report.h>
#include <pcl/core/stage_controls.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <vector>

namespace pcl {

/** \brief Observations of a sequence, each consolidated on its own.
 * \ingroup pipeline */
struct ConsolidatedObservations {
  /** \brief Indices in the sequence of those that could be read. */
  std::vector<std::size_t> places;
  Trajectory trajectory; ///< T_map_camera of each observation

  /** \brief Consolidated points with normals (NaN if there is none); sensor frame,
   * metres. */
  std::vector<PointCloud<PointNormal>::Ptr> clouds;

  /** \brief Surface area that each of these points represents, in units of the smallest
   * voxel. */
  std::vector<std::vector<float>> weights;
};

/** \brief Report of SequenceConsolidation on its last run. \ingroup pipeline */
struct SequenceConsolidationReport : Report {
  std::size_t points = 0;          ///< finite points of all observations
  std::size_t representatives = 0; ///< points of all consolidated clouds
  double min_voxel_size = 0;       ///< metres
  double max_voxel_size = 0;       ///< metres
  bool colored = false;            ///< Does an observation have colours?
};

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

  /** \brief Reads and consolidates a sequence with poses.
   * \throws InputFileException if an observation cannot be read and none may be
   * skipped, none can be read, all poses are the same though there are several, or the
   * points of an observation are too far apart to be in metres
   * \throws CancelledException if the progress callback stopped it */
  void
  compute(const ObservationSequence& sequence, ConsolidatedObservations& result);

private:
  bool skip_broken_ = false;
};

} // namespace pcl
