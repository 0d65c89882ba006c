#pragma once

#include <pcl/core/disparity_image.h>
#include <pcl/core/export.h>
#include <pcl/core/trinocular_rig.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief Whether a pixel of the reference view has a disparity, and if not, why.
 * \ingroup stereo */
enum class DisparityOutcome : std::uint8_t {
  Matched,    ///< it has a disparity
  OutOfView,  ///< the best match is outside the images of the neighbours
  Untextured, ///< below the texture threshold: the projector does not illuminate it, or
              ///< it is uniformly grey
  Uncorrelated, ///< below the correlation threshold
  Ambiguous,    ///< another disparity fits as well (ratio filter)
  OneSided,     ///< the neighbour's pixel matches another one better (left-right check)
  PairsDisagree, ///< both pairs are matched, with different disparities
  TooFewShots,   ///< fusion: matched in fewer shots than the minimum support
  Inconsistent,  ///< fusion: the disparities of the shots contradict each other
};

/** \brief Number of outcomes. \ingroup stereo */
inline constexpr std::size_t disparity_outcomes = 9;

namespace acmap {

/** \brief The names of \ref DisparityOutcome in files and messages. */
inline constexpr std::array<const char*, disparity_outcomes> disparity_outcome_names{
    "matched",
    "out of view",
    "untextured",
    "uncorrelated",
    "ambiguous",
    "one-sided",
    "pairs disagree",
    "too few shots",
    "inconsistent"};

} // namespace acmap

/** \brief Short name of the outcome, as used in reports. \ingroup stereo */
ACMAP_EXPORT const char*
nameOf(DisparityOutcome outcome);

/** \brief The disparities of one reference view, with their accuracy; all members have
 * width * height entries, row by row from the top. \ingroup stereo */
struct MatchedDisparity {
  /** \brief px along \ref disparityBaseline; NaN if there is none. */
  DisparityImage disparity;

  /** \brief One standard deviation of the disparity, px; NaN if there is none. */
  std::vector<float> sigma;

  /** \brief Number of shots that support the disparity; 0 if there is none. */
  std::vector<std::uint16_t> support;

  std::vector<DisparityOutcome> outcome;
};

namespace acmap {

/** \brief Maximum number of shots of an observation, or matched at once.
 * \ingroup stereo */
inline constexpr std::size_t max_shots = 256;

} // namespace acmap

/** \brief Number of pixels per \ref DisparityOutcome. \ingroup stereo */
ACMAP_EXPORT std::array<std::size_t, disparity_outcomes>
countOutcomes(const MatchedDisparity& matched);

/** \brief The baseline to which disparities refer, metres, above 0: the horizontal one
 * if there is a horizontal neighbour, else the vertical one; 0 without neighbours. The
 * depth of a disparity d is focal_length * baseline / (d + \ref acmap::disparityOffset).
 * \ingroup stereo */
inline double
disparityBaseline(const TrinocularRig& rig)
{
  return std::abs(rig.baseline_horizontal != 0.0 ? rig.baseline_horizontal
                                                 : rig.baseline_vertical);
}

} // namespace pcl
