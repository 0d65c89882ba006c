#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/report.h>
#include <pcl/core/stage_controls.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/pose_convention.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief What neighbouring views say of recorded poses. \ingroup pipeline */
enum class PoseVerdict {
  Agreeing,     ///< the poses fit as they are read, and in no other reading as well
  Contradicted, ///< they fit in another reading
  Undetermined  ///< several readings fit alike, or there are too few views
};

namespace acmap {

inline constexpr std::array<const char*, 3> pose_verdict_names = {
    "agreeing", "contradicted", "undetermined"};

} // namespace acmap

/** \brief Report of PoseConventionCheck on its last run. \ingroup pipeline */
struct PoseConventionReport : Report {
  PoseVerdict verdict = PoseVerdict::Undetermined;
  PoseReading stated; ///< as the poses are read
  PoseReading found;  ///< that fits best
  /** \brief Other readings that fit as well. */
  std::vector<PoseReading> equivalents;
  /** \brief By how much what was found fits better than what was stated; if they are the same,
   * than the next one. */
  double margin = 0;         ///< nats
  std::size_t pairs = 0;     ///< of views that were compared
  std::size_t differing = 0; ///< pairs that tell these two readings apart
  std::size_t agreeing = 0;  ///< of these, those that agree with what was found
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const PoseConventionReport& report, Visitor&& visit)
{
  std::vector<std::string> equivalents;
  for (const PoseReading& reading : report.equivalents)
    equivalents.push_back(textOf(reading));
  visit({"verdict"}, acmap::Named{report.verdict, acmap::pose_verdict_names});
  visit({"stated"}, textOf(report.stated));
  visit({"found"}, textOf(report.found));
  visit({"equivalents"}, equivalents);
  visit({"margin", "nats"}, report.margin);
  visit({"pairs"}, report.pairs);
  visit({"differing"}, report.differing);
  visit({"agreeing"}, report.agreeing);
}

/** \brief What neighbouring views say of the poses, with the evidence, as one line: "camera-to-world, metres,
 * 0.99 (58 of 60 pairs of views)". \ingroup pipeline */
ACMAP_EXPORT std::string
textOf(const PoseConventionReport& report);

/** \brief Checks what recorded poses mean by their views, before they are used.
 *
 * Up to 60 pairs of views, spread over the recording, are laid onto each other as the poses say
 * under each convention and unit: surfaces must meet, and no view may look through a surface that
 * another one saw. Where successive poses hardly move, half of the pairs are farther apart. What
 * fits better than what is stated by 16 nats and in four fifths of at least five pairs that
 * differ contradicts it. Poses in the axes of OpenGL's camera, and poses whose world has these
 * axes, too, give the same relative poses: views cannot tell them apart, only the map's axes
 * differ.
 * \code
 * pcl::PoseConventionCheck check;
 * check.setConvention (pcl::PoseConvention::WorldToCamera);
 * const pcl::ObservationSequence posed = check.compute (pcl::ObservationSequence ("scans"));
 * \endcode
 * Time O(pairs x points), and that of reading the views. \ingroup pipeline */
class ACMAP_EXPORT PoseConventionCheck : public StageControls<PoseConventionReport> {
public:
  /** \brief States the convention of the recorded poses (default: camera to world, as all
   * layouts are read). */
  void
  setConvention(PoseConvention convention)
  {
    convention_ = convention;
  }

  const std::optional<PoseConvention>&
  getConvention() const
  {
    return convention_;
  }

  /** \brief States the unit of the recorded poses (default: that of the sequence, metres).
   * \param[in] scale metres in a unit
   * \throws BadArgumentException unless within [1e-6, 1e6] */
  void
  setScale(double scale);

  const std::optional<double>&
  getScale() const
  {
    return scale_;
  }

  /** \brief The sequence with its poses read as they are stated; nothing is checked. */
  ObservationSequence
  read(const ObservationSequence& sequence) const;

  /** \brief Reads the poses as they are stated, and compares that with the views.
   *
   * Poses that a format defines (\ref ObservationSequence::hasRecordedPoses) are not checked.
   * Views that cannot be read are left out.
   * \return the sequence with the poses that are stated
   * \throws InputFileException if the views contradict them, naming what fits
   * \throws CancelledException if the progress callback stopped it */
  ObservationSequence
  compute(const ObservationSequence& sequence);

  /** \brief The same, but contradicted poses are only reported. */
  ObservationSequence
  assess(const ObservationSequence& sequence);

private:
  std::optional<PoseConvention> convention_;
  std::optional<double> scale_;
};

} // namespace pcl
