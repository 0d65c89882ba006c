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

/** \brief What became of a pixel of the reference view: why it has no disparity, or that
 * it has one. \ingroup stereo */
enum class DisparityOutcome : std::uint8_t {
  Matched,      ///< it has one
  OutOfView,    ///< what fits best lies outside the neighbours' images
  Untextured,   ///< below the texture threshold: the projector does not reach it, or it
                ///< is all of one grey
  Uncorrelated, ///< below the correlation threshold
  Ambiguous,    ///< another disparity fits as well (ratio filter)
  OneSided,     ///< the neighbour's pixel matches another one better (left-right check)
  PairsDisagree, ///< both pairs are sure, of different disparities
  TooFewShots,   ///< fusion: matched in fewer shots than asked for
  Inconsistent,  ///< fusion: the shots tell different disparities
};

/** \brief How many outcomes there are. \ingroup stereo */
inline constexpr std::size_t disparity_outcomes = 9;

/** \brief The outcome in a word or two, as reports have it. \ingroup stereo */
ACMAP_EXPORT const char*
nameOf(DisparityOutcome outcome);

/** \brief The disparities of one reference view and what is known of them; all members
 * have width * height entries, rows from the top. \ingroup stereo */
struct MatchedDisparity {
  /** \brief px along \ref disparityBaseline; NaN where there is none. */
  DisparityImage disparity;

  /** \brief One standard deviation of the disparity, px; NaN where there is none. */
  std::vector<float> sigma;

  /** \brief How many shots the disparity rests on; 0 where there is none. */
  std::vector<std::uint16_t> support;

  std::vector<DisparityOutcome> outcome;
};

namespace acmap {

/** \brief Shots that an observation has, or that are matched at once. \ingroup stereo */
inline constexpr std::size_t most_shots = 256;

} // namespace acmap

/** \brief Pixels by \ref DisparityOutcome. \ingroup stereo */
ACMAP_EXPORT std::array<std::size_t, disparity_outcomes>
countOutcomes(const MatchedDisparity& matched);

/** \brief The baseline that disparities are of, metres, above 0: the horizontal one where
 * there is a horizontal neighbour, else the vertical one; 0 without neighbours. The depth
 * of a disparity d is focal_length * baseline / d. \ingroup stereo */
inline double
disparityBaseline(const TrinocularRig& rig)
{
  return std::abs(rig.baseline_horizontal != 0.0 ? rig.baseline_horizontal
                                                 : rig.baseline_vertical);
}

} // namespace pcl
