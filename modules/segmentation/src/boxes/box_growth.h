#pragma once

#include "boxes/box.h"
#include "boxes/piece.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::acmap::boxes {

/** Two pieces that meet at a right angle; each is behind the other one. */
struct ConvexEdge {
  std::size_t a = 0;
  std::size_t b = 0;
};

/** Finds boxes among the pieces of a map. */
class BoxSearch {
public:
  BoxSearch(const std::vector<PlanePatch>& planes, const std::vector<Piece>& pieces);

  const std::vector<ConvexEdge>&
  edges() const
  {
    return edges_;
  }

  /** The boxes that begin at an edge, fitted to their pieces: with right angles only,
   * and with a slanted side.
   * \param[in] is_used pieces of other boxes, which they do not take
   * \return those that are sound */
  std::vector<Box>
  grow(const ConvexEdge& edge, const std::vector<bool>& is_used) const;

private:
  bool
  isBehind(const Piece& piece, const Piece& other) const;

  bool
  meet(const Piece& a, const Piece& b) const;

  bool
  isConvex(const Piece& a, const Piece& b) const;

  bool
  fits(const Box& box, std::size_t side, std::size_t piece) const;

  void
  addPieces(Box& box, const std::vector<bool>& is_used) const;

  std::optional<std::size_t>
  sideOfSlant(const Box& box, std::size_t piece) const;

  std::optional<Box>
  withSlant(const Box& box, const std::vector<bool>& is_used) const;

  bool
  fit(Box& box) const;

  /** Where faces end: coordinate along a direction, and how much it varies; metres. */
  struct End {
    double position;
    double spread;
  };

  End
  endOfFaces(const Box& box, std::size_t side) const;

  double
  furthestPoint(const Box& box, std::size_t side) const;

  bool
  isBeside(const Box& box, std::size_t side, const Piece& piece) const;

  void
  bound(Box& box) const;

  bool
  hasStraightEnds(const Box& box) const;

  bool
  isCovered(const Box& box) const;

  bool
  isSolid(const Box& box) const;

  const std::vector<PlanePatch>& planes_;
  const std::vector<Piece>& pieces_;
  std::vector<ConvexEdge> edges_;
  std::vector<std::vector<std::size_t>> neighbours_; ///< of each piece, over edges
  /** Of each piece, those that it meets in a convex edge at another angle. */
  std::vector<std::vector<std::size_t>> slanted_;
};

} // namespace pcl::acmap::boxes
