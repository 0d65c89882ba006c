#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/progress.h>
#include <pcl/core/report.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/stereo/matched_disparity.h>
#include <pcl/stereo/trinocular_matching.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl {

/** \brief Report of \ref DisparityFusion on its last run. \ingroup stereo */
struct DisparityFusionReport : Report {
  std::size_t shots = 0;     ///< with a pattern
  std::size_t off_shots = 0; ///< without a pattern, used for the colour

  /** \brief True if there was no pattern and a shot without one was matched, see
   * \ref DisparityFusion::setPassive. */
  bool is_passive = false;

  /** \brief Number of pixels per \ref DisparityOutcome. */
  std::array<std::size_t, disparity_outcomes> outcomes{};

  /** \brief Coverage after each shot with a pattern: the share of the pixels of the
   * reference whose grey levels vary enough over the shots so far, in [0, 1]. */
  std::vector<double> coverage;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const DisparityFusionReport& report, Visitor&& visit)
{
  visit({"shots"}, report.shots);
  visit({"off_shots"}, report.off_shots);
  visit({"is_passive"}, report.is_passive);
  visit({"outcomes"}, acmap::Named{report.outcomes, acmap::disparity_outcome_names});
  visit({"coverage"}, report.coverage);
}

/** \brief Computes one disparity image from the shots of an observation. Section II-A
 * of "Active Stereo Based Compact Mapping".
 *
 * - Median: each shot is matched separately; a pixel gets the lower median of its
 *   disparities, as in the paper.
 * - Statistical: each shot is matched separately; a pixel gets the mean, weighted by
 *   inverse variances, of the disparities that are within three robust standard
 *   deviations of the median (at least 1 px). A pixel that fails a chi-square test is
 *   inconsistent. Where too few shots of a pixel are matched, or they contradict each
 *   other, at least two of them count if most disparities of the pixels around confirm
 *   them. This is the future work (i) of the paper.
 * - SpaceTime: all shots are matched at once, see \ref TrinocularMatching. This is the
 *   default, because it is the most accurate and the fastest method.
 *
 * An observation without a pattern has no disparities, unless \ref setPassive allows
 * passive stereo.
 *
 * The colour is the mean of the shots without a pattern; if there are none, the mean of
 * all shots. Disparities are in pixels; only the rig is in metres. Time
 * O(n * disparities) per shot (Median, Statistical) or O(n * disparities * shots) once
 * (SpaceTime) for n pixels; memory O(n * shots).
 * \code
 * pcl::DisparityFusion fusion;
 * fusion.setInputRig (grabber.getRig ());
 * for (const auto& shot : shots)
 *   fusion.addShot (shot);
 * pcl::MatchedDisparity fused;
 * fusion.fuse (fused);
 * \endcode
 * \ingroup stereo */
class ACMAP_EXPORT DisparityFusion {
public:
  enum class Method { Median, Statistical, SpaceTime };

  DisparityFusion();
  ~DisparityFusion();
  DisparityFusion(DisparityFusion&&) noexcept;
  DisparityFusion&
  operator=(DisparityFusion&&) noexcept;

  /** \brief Geometry of the rectified frames; discards the shots.
   * \throws BadArgumentException as \ref TrinocularMatching::setInputRig */
  void
  setInputRig(const TrinocularRig& rig);

  /** \brief Settings for matching the shots. Its number of threads and its progress
   * callback are ignored, and so is its rig if the fusion has one. Discards the shots.
   */
  void
  setMatching(const TrinocularMatching& matching);

  const TrinocularMatching&
  getMatching() const;

  /** \brief A change of the method discards the shots. */
  void
  setMethod(Method method);

  Method
  getMethod() const;

  /** \brief Minimum number of shots for a disparity (default 3, or the number of shots
   * if there are fewer); used by Median and Statistical. Two are enough for Statistical
   * where the pixels around have three times this number of disparities that confirm
   * them.
   * \throws BadArgumentException unless within [1, 256] */
  void
  setMinimumSupport(int shots);

  int
  getMinimumSupport() const;

  /** \brief If true, an observation without a pattern is matched as passive stereo: its
   * first shot, with the defaults of \ref TrinocularMatching for one shot without a
   * pattern; the method has no effect then. The default is false, because an observation
   * whose shots under patterns are missing would get much worse disparities without
   * notice. Observations with a pattern are not affected. */
  void
  setPassive(bool passive);

  bool
  getPassive() const;

  /** \brief Minimum gain in coverage of the last shot for which \ref wantsAnotherShot
   * returns true (default 0.005 of the pixels).
   * \throws BadArgumentException unless within [0, 1] */
  void
  setLeastGain(double share);

  double
  getLeastGain() const;

  void
  setNumberOfThreads(unsigned threads);

  unsigned
  getNumberOfThreads() const;

  /** \brief Reports the progress of \ref addShot and \ref fuse, and can cancel them. */
  void
  setProgressCallback(ProgressCallback callback);

  /** \brief Discards the shots: the next one begins an observation. */
  void
  clear();

  /** \brief Adds a shot to the observation; Median and Statistical match it at once.
   * After an exception the previous shots are kept.
   * \throws InitFailedException without a rig
   * \throws BadArgumentException when the shot is null, an image is missing, incomplete
   * or not of the size of the rig, or there are 256 shots already
   * \throws CancelledException when the progress callback cancels */
  void
  addShot(const TrinocularFrame::ConstPtr& shot);

  /** \brief Number of shots that were added, with and without a pattern. */
  std::size_t
  shots() const;

  /** \brief Returns true if another pattern is worthwhile: there are fewer than three
   * shots with a pattern, or the last one increased the coverage by more than the
   * minimum gain. False after 256 shots. */
  bool
  wantsAnotherShot() const;

  /** \brief Fuses the shots so far; more shots may follow.
   * \param[out] fused unchanged after an exception; without a shot with a pattern all
   * pixels are \ref DisparityOutcome::TooFewShots, unless \ref setPassive is true
   * \throws InitFailedException without a rig
   * \throws CancelledException when the progress callback cancels */
  void
  fuse(MatchedDisparity& fused);

  /** \brief Hands the shots so far to another fusion with the same settings, to be fused
   * there while this one takes the shots of the next observation. The progress callback
   * stays here. */
  DisparityFusion
  release();

  /** \brief Colour of the reference view, three channels; empty without shots. */
  CameraImage
  getColor() const;

  /** \brief Report of the last \ref fuse; the coverage is that of the shots so far. */
  DisparityFusionReport
  getReport() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

/** \brief The method with the given name: `median`, `statistical` or `spacetime`.
 * \throws BadArgumentException for another name \ingroup stereo */
ACMAP_EXPORT DisparityFusion::Method
disparityFusionMethod(const std::string& name);

} // namespace pcl
