#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/report.h>
#include <pcl/core/stage_controls.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/stereo/matched_disparity.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace pcl {

/** \brief Report of \ref TrinocularMatching on its last run. \ingroup stereo */
struct TrinocularMatchingReport : Report {
  std::size_t shots = 0; ///< that were matched together

  /** \brief Number of pixels per \ref DisparityOutcome. */
  std::array<std::size_t, disparity_outcomes> outcomes{};

  std::size_t by_both_pairs = 0; ///< matched pixels on which both pairs agree
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const TrinocularMatchingReport& report, Visitor&& visit)
{
  visit({"shots"}, report.shots);
  visit({"outcomes"}, acmap::Named{report.outcomes, acmap::disparity_outcome_names});
  visit({"by_both_pairs"}, report.by_both_pairs);
}

/** \brief Computes the disparities of the pixels of the reference view with respect to
 * its neighbours, from one shot or from several shots of one position under different
 * patterns. Section II-A of "Active Stereo Based Compact Mapping"; the reference is the
 * right camera of the L-shaped rig of the paper, but the neighbours may be on any side.
 *
 * Each pair of cameras (the reference and a neighbour in its row or column) is matched
 * separately, then both results are joined: if they differ by at most the pair
 * agreement, the mean weighted by inverse variances; otherwise the pair with a much
 * smaller standard deviation or the higher correlation; if only one is matched, that
 * one. Near-horizontal lines provide no information to the horizontal pair, and
 * occlusions usually affect only one pair.
 *
 * Several shots are matched at once (space-time stereo) by zero-mean normalised
 * cross-correlation (ZNCC): of the grey levels over time with three or more shots, of
 * windows with two. With one shot, neighbourhoods of pixels are compared (census); one
 * shot without a pattern is treated as passive stereo. Costs are summed along eight
 * paths (Hirschmueller, 2008) in integers; the sub-pixel disparity is at the maximum of
 * the correlation among quarter pixels. The standard deviation follows from the value
 * and the curvature of the correlation at this maximum.
 *
 * Setters that also exist in PCL's StereoMatching have the same names. Disparities are
 * in pixels; only the rig is in metres. Time O(n * disparities * shots) for n pixels;
 * memory 4 bytes for each pixel and disparity of a pair, 2 bytes from five shots on, for
 * 2 pairs at once.
 * \code
 * pcl::TrinocularMatching matching;
 * matching.setInputRig (grabber.getRig ());
 * matching.setMaxDisparity (96);
 * pcl::MatchedDisparity matched;
 * matching.match (shots, matched);
 * \endcode
 * \ingroup stereo */
class ACMAP_EXPORT TrinocularMatching : public StageControls<TrinocularMatchingReport> {
public:
  TrinocularMatching();
  ~TrinocularMatching();

  /** \brief Copies the settings of \a other, but not its report. */
  TrinocularMatching(const TrinocularMatching& other);
  TrinocularMatching&
  operator=(const TrinocularMatching& other);

  /** \brief Geometry of the rectified frames.
   * \throws BadArgumentException for a rig with invalid values, without neighbours, or
   * whose baselines differ by more than a factor of 16 */
  void
  setInputRig(const TrinocularRig& rig);

  /** \brief \throws InitFailedException without a rig */
  const TrinocularRig&
  getInputRig() const;

  /** \brief Minimum disparity of the search range, px (default 0).
   * \throws BadArgumentException unless within [0, 4095] */
  void
  setXOffset(int offset);

  int
  getXOffset() const
  {
    return x_offset_;
  }

  /** \brief Number of disparities in the search range, from the offset on (default 64).
   * \throws BadArgumentException unless within [8, 1024] */
  void
  setMaxDisparity(int disparities);

  int
  getMaxDisparity() const
  {
    return max_disparity_;
  }

  /** \brief Uniqueness: percent by which the cost of every disparity that is more than
   * 1 px away from the best one must be higher (default 0: no such test).
   * \throws BadArgumentException unless within [0, 100] */
  void
  setRatioFilter(int percent);

  int
  getRatioFilter() const
  {
    return ratio_filter_;
  }

  /** \brief Texture: minimum standard deviation of the grey levels that are compared,
   * over the shots or, with one or two shots, over the window. The default is 2 with
   * three or more shots, which masks what the projector does not illuminate; 1 with one
   * or two; 0 for one without a pattern.
   * \throws BadArgumentException unless within [0, 128] grey levels */
  void
  setPeakFilter(double deviation);

  /** \brief The value that was set; no value means the default for the number of shots.
   */
  std::optional<double>
  getPeakFilter() const
  {
    return peak_filter_;
  }

  /** \brief Minimum correlation (ZNCC) of a match (default 0.75 with five or more
   * shots, 0.5 with three or four, 0.2 with one or two, -1 for one without a pattern).
   * \throws BadArgumentException unless within [-1, 1] */
  void
  setCorrelationThreshold(double correlation);

  std::optional<double>
  getCorrelationThreshold() const
  {
    return correlation_threshold_;
  }

  /** \brief If true, the pixel of the neighbour must match back (default true). */
  void
  setLeftRightCheck(bool check)
  {
    left_right_check_ = check;
  }

  bool
  getLeftRightCheck() const
  {
    return left_right_check_;
  }

  /** \brief Maximum distance between the pixel and the match back, px (default 1).
   * \throws BadArgumentException unless within [0, 16] */
  void
  setLeftRightCheckThreshold(int threshold);

  int
  getLeftRightCheckThreshold() const
  {
    return left_right_threshold_;
  }

  /** \brief Maximum difference at which two pairs agree, px (default 1).
   * \throws BadArgumentException unless within [0.1, 16] */
  void
  setPairAgreement(double difference);

  double
  getPairAgreement() const
  {
    return pair_agreement_;
  }

  /** \brief If true, a pixel for which both pairs are matched but disagree is rejected
   * (default false: the better of both disparities is taken). */
  void
  setRequirePairAgreement(bool require)
  {
    require_agreement_ = require;
  }

  bool
  getRequirePairAgreement() const
  {
    return require_agreement_;
  }

  /** \brief Matches one shot.
   * \param[in] shot grey or in colour, with all cameras of the rig
   * \param[out] matched unchanged after an exception
   * \throws InitFailedException without a rig
   * \throws BadArgumentException when an image is missing, incomplete or not of the
   * size of the rig
   * \throws CancelledException when the progress callback cancels */
  void
  match(const TrinocularFrame& shot, MatchedDisparity& matched);

  /** \brief Matches shots of one position together. Shots without a pattern are
   * excluded if there are others; if there are no others, only the first shot is
   * matched. A remark reports both cases.
   * \param[in] shots at least one, at most 256
   * \throws as above; BadArgumentException also for no shot, too many, and a null one
   */
  void
  match(const std::vector<TrinocularFrame::ConstPtr>& shots, MatchedDisparity& matched);

private:
  struct Memory;

  void
  matchPairs(const std::vector<const TrinocularFrame*>& shots);

  /** \return the number of pixels on which both pairs agree */
  std::size_t
  joinPairs(std::size_t shots, MatchedDisparity& joined) const;

  std::optional<TrinocularRig> rig_;
  int x_offset_ = 0;
  int max_disparity_ = 64;
  int ratio_filter_ = 0;
  std::optional<double> peak_filter_;
  std::optional<double> correlation_threshold_;
  bool left_right_check_ = true;
  int left_right_threshold_ = 1;
  double pair_agreement_ = 1.0;
  bool require_agreement_ = false;
  std::unique_ptr<Memory> memory_; // kept between runs: it is large
};

} // namespace pcl
