#pragma once

#include "labeling/candidate_grid.h"

namespace pcl::acmap::labeling {

/** On which side of its neighbours each plane lies: in front at an inner edge, such as
 * between wall and floor, behind at an outer one, as of a box. */
class Junctions {
public:
  Junctions(const KnownPlanes& known, const CandidateGrid& grid);

  /** Of points of plane \a a near plane \a b: 1 in front of b, -1 behind it, 0 where that
   * does not tell them apart. */
  int
  side(std::size_t a, std::size_t b) const
  {
    const auto end = neighbours_.begin() + first_[a + 1];
    const auto found =
        std::lower_bound(neighbours_.begin() + first_[a],
                         end,
                         b,
                         [](const Neighbour& neighbour, std::size_t plane) {
                           return neighbour.plane < plane;
                         });
    return found != end && found->plane == b ? found->side : 0;
  }

private:
  /** What a plane has on one side. */
  struct Neighbour {
    std::uint32_t plane;
    std::int8_t side;
  };

  std::vector<std::ptrdiff_t> first_; ///< of each plane's neighbours, and their number
  std::vector<Neighbour> neighbours_; ///< ascending for each plane
};

} // namespace pcl::acmap::labeling
