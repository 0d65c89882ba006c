#pragma once

#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/report.h>
#include <pcl/core/stage_controls.h>
#include <pcl/pipeline/cost_callback.h>
#include <pcl/pipeline/depth_sensor.h>
#include <pcl/pipeline/observation_sequence.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace pcl {

class RankedWork;

namespace acmap {

class MapRows;

/** \brief Observations that were merged, in their order. */
struct MergedRows {
  CloudRows cloud; ///< as MergedCloud::cloud
  std::vector<Eigen::Isometry3d>
      poses; ///< in the frame of the cloud, of those that could be read
  std::vector<std::string> remarks;
  std::vector<std::string> of_poses; ///< remarks of all observations about their poses
  std::size_t refined = 0;           ///< number of those with quantised depth
  bool are_colored = true;           ///< Do all of them have colours?
};

} // namespace acmap

/** \brief All points of a sequence in one frame. \ingroup pipeline */
struct MergedCloud {
  /** \brief Finite points with fields `x y z rgb view`; `view` is the position of the
   * observation among the viewpoints. Metres. */
  CloudRows cloud;
  /** \brief Sensor positions, one per observation, metres. */
  std::vector<Eigen::Vector3f> viewpoints;
};

/** \brief Report of ObservationMerging on its last run. \ingroup pipeline */
struct MergingReport : Report {
  std::size_t observations = 0; ///< that were read
  std::size_t refined = 0;      ///< of these, those with quantised depth
  std::size_t points = 0;       ///< of the merged cloud
  std::size_t every = 1; ///< step between the finite points that were kept: every n-th
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const MergingReport& report, Visitor&& visit)
{
  visit({"observations"}, report.observations);
  visit({"refined"}, report.refined);
  visit({"points"}, report.points);
  visit({"every"}, report.every);
}

/** \brief Merges the observations of a sequence to one cloud with the observation of
 * each point in a field; the input of \ref PlaneMapping.
 *
 * Quantised depth is refined first (\ref refineQuantisedDepth).
 * \code
 * pcl::ObservationMerging merging;
 * pcl::MergedCloud merged;
 * merging.compute (pcl::ObservationSequence ("observations"), merged);
 * \endcode
 * \ingroup pipeline */
class ACMAP_EXPORT ObservationMerging : public StageControls<MergingReport> {
public:
  /** \brief Sets the kind of sensor that measured the observations (default
   * Automatic). */
  void
  setDepthSensor(DepthSensor sensor)
  {
    sensor_ = sensor;
  }

  /** \brief Sets the maximum number of points (default 50 million): above it, only
   * every second, fourth ... point is kept.
   * \throws BadArgumentException if it is 0 */
  void
  setMaximumPoints(std::size_t points);

  /** \brief Sets the frame of the merged cloud (default: that of the map).
   * \param[in] T_cloud_map metres */
  void
  setFrame(const Eigen::Isometry3d& T_cloud_map)
  {
    T_cloud_map_ = T_cloud_map;
  }

  /** \brief Leaves out observations that cannot be read, with a remark (default
   * false). */
  void
  setSkipBroken(bool skip)
  {
    skip_broken_ = skip;
  }

  void
  setCostCallback(CostCallback callback)
  {
    cost_callback_ = std::move(callback);
  }

  /** \brief Shares the observations out over ranks (default: none): those of the sequence
   * that \a work was made of, which must exist as long as the merged cloud. */
  void
  setRankedWork(std::shared_ptr<RankedWork> work)
  {
    ranked_work_ = std::move(work);
  }

  /** \brief Merges a sequence with poses.
   * \throws InputFileException if an observation cannot be read and none may be
   * skipped, none can be read, or all poses are the same though there are several
   * \throws CancelledException if the progress callback stopped it
   * \throws what the cost callback throws */
  void
  compute(const ObservationSequence& sequence, MergedCloud& merged);

  /** \brief Merges some of the observations of a sequence for RankedWork. There is no
   * maximum number of points, and nothing need be readable.
   * \throws InputFileException if an observation cannot be read and none may be skipped */
  acmap::MergedRows
  mergeShare(const ObservationSequence& sequence);

private:
  void
  merge(const ObservationSequence& sequence, MergedCloud& merged);

  void
  add(const ObservationSequence& sequence,
      std::size_t end,
      acmap::MapRows& rows,
      acmap::MergedRows& merged) const;

  void
  addOfRanks(acmap::MapRows& rows, acmap::MergedRows& merged) const;

  DepthSensor sensor_ = DepthSensor::Automatic;
  Eigen::Isometry3d T_cloud_map_ = Eigen::Isometry3d::Identity();
  std::size_t maximum_points_ = 50000000;
  bool skip_broken_ = false;
  CostCallback cost_callback_;
  std::shared_ptr<RankedWork> ranked_work_;
};

} // namespace pcl
