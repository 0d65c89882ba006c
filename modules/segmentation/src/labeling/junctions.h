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
    return sides_[a * planes_ + b];
  }

private:
  std::size_t planes_;
  std::vector<std::int8_t> sides_;
};

} // namespace pcl::acmap::labeling
