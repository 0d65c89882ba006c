#pragma once

#include "pair_costs.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief The disparity of least cost for each pixel of a reference view, rows from the
 * top. */
struct PairWinners {
  std::vector<std::int16_t> index; ///< from the range's first on

  /** \brief By pixel of the neighbour's view: the column of the reference that matches it
   * best, -1 where none can. */
  std::vector<std::int16_t> matched_by;

  /** \brief Percent by which disparities more than 1 px away cost more, at least, in 3 x 3
   * pixels without paths. */
  std::vector<std::uint8_t> uniqueness;
};

/** \brief What \ref PathSums needs besides costs. */
struct PathSettings {
  std::int16_t small_penalty = 0;
  std::int16_t large_penalty = 0;
  int contrast = 0;        ///< as in \ref MatchingRecipe
  bool uniqueness = false; ///< whether it is asked for
};

/** \brief Sums costs along eight paths (semi-global matching, Hirschmueller 2008) and takes
 * the least. Keeps its memory from run to run. */
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

  void
  findInRow(int y, const DisparityRange& range, PairWinners&);

  CostVolume sums_;
  std::vector<std::int16_t> target_least_;
  std::vector<std::int16_t> target_pixel_;
};

} // namespace pcl::acmap
