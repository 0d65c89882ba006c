#pragma once

#include "boxes/box.h"
#include "boxes/piece.h"
#include "recesses/opening.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::acmap::recesses {

/** A piece that lies behind a parallel wall. */
struct LeafBehindWall {
  std::size_t leaf = 0; ///< number of the piece
  std::size_t wall = 0; ///< number of the plane
};

/** Finds recesses among the pieces of a map; they are boxes as in recess_sides.h. */
class RecessSearch {
public:
  /** \param[in] up of length 1, in the frame of the planes */
  RecessSearch(const std::vector<PlanePatch>& planes,
               const std::vector<boxes::Piece>& pieces,
               const Eigen::Vector3d& up);

  const std::vector<LeafBehindWall>&
  pairs() const
  {
    return pairs_;
  }

  /** The recess of a leaf and a wall, fitted to both.
   * \return nothing where the wall has no rectangular opening before the leaf, or the
   * leaf does not close it */
  std::optional<boxes::Box>
  fit(const LeafBehindWall& pair) const;

private:
  std::optional<std::size_t>
  floorBelow(const Opening& opening) const;

  bool
  close(Opening& opening, std::size_t wall, boxes::Side& foot) const;

  double
  coverOfWall(const Opening& opening, std::size_t wall) const;

  std::vector<std::size_t>
  leavesIn(const Opening& opening, std::size_t plane) const;

  boxes::Box
  boxOf(const Opening& opening, const boxes::Side& foot) const;

  void
  fitToPlanes(boxes::Box& box) const;

  const std::vector<PlanePatch>& planes_;
  const std::vector<boxes::Piece>& pieces_;
  Eigen::Vector3d up_;
  std::vector<std::vector<std::size_t>> pieces_of_; ///< of each plane
  std::vector<LeafBehindWall> pairs_;
};

} // namespace pcl::acmap::recesses
