#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/report.h>
#include <pcl/core/stage_controls.h>
#include <pcl/egomotion/egomotion_types.h>
#include <pcl/egomotion/revisit_detection_types.h>
#include <pcl/pipeline/estimated_poses.h>
#include <pcl/pipeline/observation_sequence.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>

namespace pcl {

/** \brief Report of SequenceAlignment on its last run. \ingroup pipeline */
struct SequenceAlignmentReport : Report {
  RevisitReport revisits;
  std::size_t places = 0;   ///< pairs of views, one of each sequence, of one place
  std::size_t agreeing = 0; ///< of these, those that agree with the result
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const SequenceAlignmentReport& report, Visitor&& visit)
{
  visit({"revisits"}, report.revisits);
  visit({"places"}, report.places);
  visit({"agreeing"}, report.agreeing);
}

/** \brief Finds the motion between the maps of two sequences, by places that both have
 * seen (\ref RevisitDetection): a second session extends the map of a first one.
 *
 * Each such place proposes a motion. The one that most others agree with, within 0.5 m and
 * 5 degrees at their views, is taken, the mean of those that agree with it being formed. In
 * \ref MotionModel::Planar, both maps are assumed to be level where it tilts them by less
 * than a degree: the tilt, and the height, are then removed.
 * \code
 * pcl::SequenceAlignment alignment;
 * alignment.setInputTarget (pcl::ObservationSequence ("first"));
 * const auto T_first_second = alignment.align (pcl::ObservationSequence ("second"));
 * \endcode
 * \ingroup pipeline */
class ACMAP_EXPORT SequenceAlignment : public StageControls<SequenceAlignmentReport> {
public:
  /** \brief Sets the sequence to whose map others are aligned.
   * \param[in] sequence with poses; organized observations with colours */
  void
  setInputTarget(const ObservationSequence& sequence)
  {
    target_ = sequence;
  }

  /** \brief Sets how maps may be moved (default Planar). */
  void
  setMotionModel(MotionModel model)
  {
    model_ = model;
  }

  MotionModel
  getMotionModel() const
  {
    return model_;
  }

  /** \brief Aligns a sequence.
   * \param[in] source with poses in a map of its own
   * \return T_target_source of the maps; nothing if no place was seen by both
   * \throws InitFailedException without a target
   * \throws InputFileException if an observation cannot be read, is not organized, or has
   * no colours
   * \throws CancelledException if the progress callback stopped it */
  std::optional<Eigen::Isometry3d>
  align(const ObservationSequence& source);

private:
  std::optional<ObservationSequence> target_;
  MotionModel model_ = MotionModel::Planar;
};

/** \brief Poses of the observations of an earlier map, and of those that extend it, in the
 * frame of the earlier map.
 * \param[in] joined from \ref ObservationSequence::followedBy
 * \param[in] earlier number of observations of the earlier map, the target of the alignment
 * \param[in] noise of the motions of the new ones
 * \throws EmptyInputException if no place was seen by both
 * \throws what \ref SequenceAlignment::align does \ingroup pipeline */
ACMAP_EXPORT EstimatedPoses
extendedPoses(const ObservationSequence& joined,
              std::size_t earlier,
              SequenceAlignment& alignment,
              const std::optional<OdometryNoise>& noise);

} // namespace pcl
