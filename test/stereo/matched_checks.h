#pragma once

#include <pcl/stereo/trinocular_matching.h>

#include <cstddef>
#include <vector>

namespace pcl::acmap::test {

/** \brief How disparities differ from the truth, over the pixels that have one. */
struct MatchErrors {
  std::size_t pixels = 0;  ///< with a truth
  double missing = 0;      ///< share of them without a disparity
  double bad = 0;          ///< share of them off by more than 1 px
  double median = 0;       ///< px, of the absolute errors
  double beyond = 0;       ///< share of those matched that are off by more than 5 sigma
  double rms_in_sigma = 0; ///< root mean square of the other errors, each in its sigma
};

/** \param[in] truth px, NaN where none is asked for */
MatchErrors
errorsOf(const MatchedDisparity& matched, const DisparityImage& truth);

/** \brief Share of the pixels. */
double
shareMatched(const MatchedDisparity& matched);

/** \brief Whether two say the same, byte for byte. */
bool
isSame(const MatchedDisparity& a, const MatchedDisparity& b);

/** \brief How alike two are that need not be the same. */
struct Likeness {
  double same_outcome = 0; ///< share of the pixels
  double matched = 0;      ///< share of the pixels, in both
  double farthest = 0;     ///< px, of the disparities that both have, but for 1 %
};

Likeness
likenessOf(const MatchedDisparity& a, const MatchedDisparity& b);

/** \brief Matches, and expects of the result what always holds: sizes, that each pixel has
 * a disparity, a standard deviation and support or none of them, within what was searched,
 * and that the report counts them. */
MatchedDisparity
matchSoundly(TrinocularMatching& matching,
             const std::vector<TrinocularFrame::Ptr>& shots);

/** \brief The same with a new object. */
MatchedDisparity
matchSoundly(const TrinocularRig& rig, const std::vector<TrinocularFrame::Ptr>& shots);

} // namespace pcl::acmap::test
