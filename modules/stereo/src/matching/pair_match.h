#pragma once

#include "pair_refinement.h"
#include "pair_winners.h"
#include "recipe.h"

#include <pcl/core/trinocular_frame.h>
#include <pcl/stereo/matched_disparity.h>

#include <vector>

namespace pcl::acmap {

/** \brief When a match is believed. */
struct MatchTests {
  int uniqueness = 0;           ///< percent, 0 for no such test
  double deviation = 0;         ///< grey levels, at least
  double correlation = -1;      ///< at least
  bool left_right = true;       ///< whether it is tested
  int left_right_threshold = 1; ///< px
};

/** \brief Images of a pair in all shots, and how they are laid. */
struct PairImages {
  std::vector<const CameraImage*> reference;
  std::vector<const CameraImage*> target;
  PairLayout layout;
};

/** \brief What a pair tells of each pixel of the reference image, rows from the top. */
struct PairMatch {
  std::vector<float> disparity;   ///< px
  std::vector<float> sigma;       ///< px
  std::vector<float> correlation; ///< as in \ref RefinedPair
  std::vector<DisparityOutcome> outcome;
};

/** \brief Matches a pair of cameras; keeps its memory from run to run. */
class PairMatcher {
public:
  /** \brief Runs in all threads of the caller's arena; the result does not depend on them.
   */
  void
  match(const PairImages& images,
        const MatchingRecipe& recipe,
        const DisparityRange& range,
        const MatchTests& tests,
        PairMatch& match);

private:
  ShotStack reference_;
  ShotStack target_;
  CostVolume costs_;
  PathSums paths_;
  PairWinners winners_;
  RefinedPair refined_;
};

} // namespace pcl::acmap
