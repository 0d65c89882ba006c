#pragma once

#include "byte_paths.h"
#include "pair_refinement.h"
#include "pair_winners.h"
#include "recipe.h"

#include <pcl/core/trinocular_frame.h>
#include <pcl/stereo/matched_disparity.h>

#include <vector>

namespace pcl::acmap {

/** \brief Conditions under which a match is accepted. */
struct MatchTests {
  int uniqueness = 0;           ///< percent, 0 for no such test
  double deviation = 0;         ///< minimum, grey levels
  double correlation = -1;      ///< minimum
  bool left_right = true;       ///< if true, the left-right check is applied
  int left_right_threshold = 1; ///< px
};

/** \brief Images of a pair in all shots, and their layout. */
struct PairImages {
  std::vector<const CameraImage*> reference;
  std::vector<const CameraImage*> target;
  PairLayout layout;
};

/** \brief Result of a pair for each pixel of the reference image, row by row from the
 * top. */
struct PairMatch {
  std::vector<float> disparity;   ///< px
  std::vector<float> sigma;       ///< px
  std::vector<float> correlation; ///< as in \ref RefinedPair
  std::vector<DisparityOutcome> outcome;
};

/** \brief Matches a pair of cameras; keeps its memory from run to run. */
class PairMatcher {
public:
  /** \brief Runs in all threads of the caller's arena; the result does not depend on
   * them. */
  void
  match(const PairImages& images,
        const MatchingRecipe& recipe,
        const DisparityRange& range,
        const MatchTests& tests,
        PairMatch& match);

private:
  void
  findWinners(const MatchingRecipe& recipe,
              const DisparityRange& range,
              bool uniqueness);

  ShotStack reference_;
  ShotStack target_;
  CostVolume costs_;
  PathSums paths_;
  ByteVolume byte_costs_;
  BytePaths byte_paths_;
  PairWinners winners_;
  RefinedPair refined_;
};

} // namespace pcl::acmap
