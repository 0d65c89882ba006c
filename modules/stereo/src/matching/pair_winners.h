#pragma once

#include "pair_costs.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief The disparity with the minimum cost for each pixel of a reference view, row
 * by row from the top. */
struct PairWinners {
  std::vector<std::int16_t> index; ///< relative to the first one of the range

  /** \brief For each pixel of the neighbour's view: the column of the reference that
   * matches it best, -1 if there is none. */
  std::vector<std::int16_t> matched_by;

  /** \brief Percent by which the costs of all disparities more than 1 px away are
   * higher, in 3 x 3 pixels without paths. */
  std::vector<std::uint8_t> uniqueness;

  void
  resize(std::size_t pixels, bool with_uniqueness);
};

/** \brief Settings of \ref PathSums. */
struct PathSettings {
  std::int16_t small_penalty = 0;
  std::int16_t large_penalty = 0;
  int contrast = 0;        ///< as in \ref MatchingRecipe
  bool uniqueness = false; ///< if true, the uniqueness is computed
};

/** \brief Sums costs along eight paths (semi-global matching, Hirschmueller 2008) and
 * finds the minima. Keeps its memory from run to run. */
class PathSums {
public:
  /** \param[in] image the reference, for the contrast
   * \param[in] costs of \a range */
  void
  findWinners(const ShotStack& image,
              const DisparityRange& range,
              const PathSettings& settings,
              CostVolume& costs,
              PairWinners& winners);

private:
  class Pass;

  CostVolume sums_;
};

} // namespace pcl::acmap
