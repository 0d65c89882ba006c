#pragma once

#include <pcl/stereo/trinocular_matching.h>

#include <cstddef>
#include <vector>

namespace pcl::acmap::test {

/** \brief Errors of disparities at the pixels with a true disparity. */
struct MatchErrors {
  std::size_t pixels = 0;  ///< with a true disparity
  double missing = 0;      ///< fraction of these without a disparity
  double bad = 0;          ///< fraction of these with an error of more than 1 px
  double median = 0;       ///< px, of the absolute errors
  double beyond = 0;       ///< fraction of the matched ones with an error of more than
                           ///< 5 sigma
  double rms_in_sigma = 0; ///< RMS of the other errors, in units of sigma
};

/** \param[in] truth px, NaN for pixels that are ignored */
MatchErrors
errorsOf(const MatchedDisparity& matched, const DisparityImage& truth);

/** \brief Fraction of the pixels that are matched. */
double
shareMatched(const MatchedDisparity& matched);

/** \brief Are both results equal byte by byte? */
bool
isSame(const MatchedDisparity& a, const MatchedDisparity& b);

/** \brief Similarity of two results. */
struct Likeness {
  double same_outcome = 0; ///< fraction of the pixels
  double matched = 0;      ///< fraction of the pixels, in both results
  double farthest = 0;     ///< px, 99 % quantile of the differences of disparities
};

Likeness
likenessOf(const MatchedDisparity& a, const MatchedDisparity& b);

/** \brief Matches, and checks invariants of the result: sizes; each pixel has a
 * disparity, a standard deviation and support or none of them; disparities are within
 * the search range; the report has the correct counts. */
MatchedDisparity
matchSoundly(TrinocularMatching& matching,
             const std::vector<TrinocularFrame::Ptr>& shots);

/** \brief As above with a new object. */
MatchedDisparity
matchSoundly(const TrinocularRig& rig, const std::vector<TrinocularFrame::Ptr>& shots);

} // namespace pcl::acmap::test
