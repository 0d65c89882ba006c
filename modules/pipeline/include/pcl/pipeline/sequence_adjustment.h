#pragma once

#include <pcl/core/export.h>
#include <pcl/core/stage_controls.h>
#include <pcl/core/trajectory.h>
#include <pcl/egomotion/revisit_detection_types.h>
#include <pcl/mapping/entropy_rectification_types.h>
#include <pcl/mapping/plane_adjustment_types.h>
#include <pcl/pipeline/observation_sequence.h>

#include <optional>

namespace pcl {

/** \brief Adjusts the poses of a sequence by the planes that its observations share:
 * \ref PlaneAdjustment on points as they were measured, with their `sigma` if the first
 * observation has it. If the observations are organized and have colours,
 * \ref RevisitDetection finds those that see the same place at different times, and they
 * take part. Observations are read when they are needed.
 * \ingroup pipeline */
class ACMAP_EXPORT SequenceAdjustment : public StageControls<PlaneAdjustmentReport> {
public:
  /** \brief Sets the expected errors of the poses, from one to the next; their scale is
   * estimated.
   * \throws BadArgumentException naming the value */
  void
  setOdometryNoise(const OdometryNoise& noise);

  const OdometryNoise&
  getOdometryNoise() const
  {
    return odometry_;
  }

  /** \brief Sets the poses of the same observations before a rectification (default:
   * none). They are adjusted first: a rectification moves poses in one plane only, and is
   * wrong more often than the planes where the drift also tilts. If this is refused or
   * undetermined, the poses of the sequence are adjusted.
   * \param[in] poses one per observation; empty for none */
  void
  setPosesBefore(std::vector<Eigen::Isometry3d> poses)
  {
    before_ = std::move(poses);
  }

  /** \brief Adjusts the poses of a sequence.
   * \param[out] trajectory the stamps of the sequence; the poses that were given if they
   * are not adjusted
   * \throws BadArgumentException if there is another number of poses before
   * \throws InputFileException if an observation cannot be read
   * \throws CancelledException if the progress callback stopped it */
  void
  compute(const ObservationSequence& sequence, Trajectory& trajectory);

  /** \brief Report of \ref RevisitDetection in the last run; none without images. */
  const std::optional<RevisitReport>&
  getRevisitReport() const
  {
    return revisits_;
  }

private:
  OdometryNoise odometry_;
  std::vector<Eigen::Isometry3d> before_;
  std::optional<RevisitReport> revisits_;
};

} // namespace pcl
