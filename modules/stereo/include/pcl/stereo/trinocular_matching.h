#pragma once

#include <pcl/core/export.h>
#include <pcl/core/report.h>
#include <pcl/core/stage_controls.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/stereo/matched_disparity.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace pcl {

/** \brief What \ref TrinocularMatching tells about its last run. \ingroup stereo */
struct TrinocularMatchingReport : Report {
  std::size_t shots = 0; ///< that were matched together

  /** \brief Pixels by \ref DisparityOutcome. */
  std::array<std::size_t, disparity_outcomes> outcomes{};

  std::size_t by_both_pairs = 0; ///< matched pixels that both pairs agree on
};

/** \brief Finds for the pixels of the reference view how far they move into the views of
 * the neighbours, from one shot or from several of one place under different patterns.
 * Section II-A of "Active Stereo Based Compact Mapping"; the reference is the right camera
 * of the paper's L-shaped rig, any other side will do.
 *
 * Each pair of cameras is matched on its own (a neighbour in the row or in the column),
 * then both are joined: within the pair agreement the mean by their variances, else the one
 * that is much surer, or fits better, else the one that there is. Near-horizontal lines say
 * nothing to the horizontal pair, and occlusion spoils one pair at a time.
 *
 * Several shots are matched at once (space-time stereo), by zero-mean normalised correlation
 * (ZNCC): from three on a pixel is compared by its grey levels over time, two are compared
 * by windows. With one shot a pixel is compared by its neighbourhood; one without a pattern
 * is taken for passive stereo. Costs are summed along eight paths (Hirschmueller, 2008) in
 * whole numbers; the sub-pixel disparity is the place of highest correlation among quarter
 * pixels. The standard deviation follows from the curvature of the correlation there, and
 * from what it lacks of 1.
 *
 * Setters that PCL's StereoMatching has too are called as there. Metres only in the rig;
 * disparities in pixels. Time O(n * disparities * shots) for n pixels; memory 4 bytes for
 * each pixel and disparity of a pair, 2 pairs at once.
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

  /** \brief The settings of another one; not its report. */
  TrinocularMatching(const TrinocularMatching& other);
  TrinocularMatching&
  operator=(const TrinocularMatching& other);

  /** \brief Geometry of the frames, rectified.
   * \throws BadArgumentException for a rig that no camera can have, without neighbours, or
   * whose baselines differ more than 16 times */
  void
  setInputRig(const TrinocularRig& rig);

  /** \brief \throws InitFailedException without a rig */
  const TrinocularRig&
  getInputRig() const;

  /** \brief The least disparity that is searched for, px (default 0).
   * \throws BadArgumentException unless within [0, 4095] */
  void
  setXOffset(int offset);

  int
  getXOffset() const
  {
    return x_offset_;
  }

  /** \brief How many disparities are searched for, from the offset on (default 64).
   * \throws BadArgumentException unless within [8, 1024] */
  void
  setMaxDisparity(int disparities);

  int
  getMaxDisparity() const
  {
    return max_disparity_;
  }

  /** \brief Uniqueness: percent by which every disparity farther than 1 px from the best
   * one must cost more (default 0: no such test).
   * \throws BadArgumentException unless within [0, 100] */
  void
  setRatioFilter(int percent);

  int
  getRatioFilter() const
  {
    return ratio_filter_;
  }

  /** \brief Texture: least standard deviation of the grey levels that are compared, over
   * the shots or, with one or two shots, over the window (default 2 with several shots: the
   * mask of what the projector reaches; 1 with one or two; 0 for one without a pattern).
   * \throws BadArgumentException unless within [0, 128] grey levels */
  void
  setPeakFilter(double deviation);

  /** \brief What was set; no value: by the number of shots. */
  std::optional<double>
  getPeakFilter() const
  {
    return peak_filter_;
  }

  /** \brief Least correlation (ZNCC) of a match (default 0.75 from five shots on, 0.5
   * with three or four, 0.2 with one or two, -1 for one without a pattern).
   * \throws BadArgumentException unless within [-1, 1] */
  void
  setCorrelationThreshold(double correlation);

  std::optional<double>
  getCorrelationThreshold() const
  {
    return correlation_threshold_;
  }

  /** \brief Whether the neighbour's pixel must match back (default true). */
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

  /** \brief How far it may match back beside the pixel, px (default 1).
   * \throws BadArgumentException unless within [0, 16] */
  void
  setLeftRightCheckThreshold(int threshold);

  int
  getLeftRightCheckThreshold() const
  {
    return left_right_threshold_;
  }

  /** \brief Up to how many px of difference two pairs tell the same disparity (default 1).
   * \throws BadArgumentException unless within [0.1, 16] */
  void
  setPairAgreement(double difference);

  double
  getPairAgreement() const
  {
    return pair_agreement_;
  }

  /** \brief Whether a pixel for which both pairs are sure of different disparities has none
   * (default false: the one that is much surer, or fits better). */
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
   * \param[out] matched untouched after an exception
   * \throws InitFailedException without a rig
   * \throws BadArgumentException when an image is missing, has another size than the rig
   * or not all its values
   * \throws CancelledException when the progress callback says so */
  void
  match(const TrinocularFrame& shot, MatchedDisparity& matched);

  /** \brief Matches shots of one place together. Those without a pattern are left out where
   * there are others; where there are none, the first shot alone is matched. A remark tells
   * both.
   * \param[in] shots at least one, at most 256
   * \throws as above; BadArgumentException also for no shot, too many, and a null one */
  void
  match(const std::vector<TrinocularFrame::ConstPtr>& shots, MatchedDisparity& matched);

private:
  struct Memory;

  void
  matchPairs(const std::vector<const TrinocularFrame*>& shots);

  /** \return pixels that both pairs agree on */
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
