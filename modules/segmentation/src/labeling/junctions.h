#pragma once

#include "labeling/candidate_grid.h"

namespace pcl::acmap::labeling {

/** The side of its neighbours on which each plane lies: in front of them at a concave
 * edge, such as between a wall and the floor, behind them at a convex edge, such as
 * that of a box. */
class Junctions {
public:
  Junctions(const KnownPlanes& known, const CandidateGrid& grid);

  /** Side of plane \a b on which the points of plane \a a near it lie: 1 in front of b,
   * -1 behind it, 0 if there is no clear side. */
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
  /** A neighbour and the side of it on which the plane lies. */
  struct Neighbour {
    std::uint32_t plane;
    std::int8_t side;
  };

  std::vector<std::ptrdiff_t> first_; ///< first neighbour of each plane, and the end
  std::vector<Neighbour> neighbours_; ///< sorted by plane, then by neighbour
};

} // namespace pcl::acmap::labeling
