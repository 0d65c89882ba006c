#pragma once

#include <pcl/core/export.h>
#include <pcl/core/stage_controls.h>
#include <pcl/core/trajectory.h>
#include <pcl/mapping/entropy_rectification_types.h>
#include <pcl/mapping/plane_adjustment_types.h>
#include <pcl/pipeline/observation_sequence.h>

namespace pcl {

/** \brief Adjusts the poses of a sequence by the planes that its observations share:
 * \ref PlaneAdjustment on points as they were measured, with their `sigma` if the first
 * observation has it. Observations are read when they are needed.
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

  /** \brief Adjusts the poses of a sequence.
   * \param[out] trajectory the stamps of the sequence; the poses that were given if they
   * are not adjusted
   * \throws InputFileException if an observation cannot be read
   * \throws CancelledException if the progress callback stopped it */
  void
  compute(const ObservationSequence& sequence, Trajectory& trajectory);

private:
  OdometryNoise odometry_;
};

} // namespace pcl
