#pragma once

#include "tree_cells.h"

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief Query in floats for the apex over an edge a b: it finds the points whose
 * angle apb may be the largest, with a margin above all rounding errors. The decision
 * is made in double precision. */
struct ApexQuery {
  std::int32_t a, b;       ///< ends of the edge, excluded from the result
  std::int32_t left_out;   ///< also excluded; -1: none
  float at_a[3], at_b[3];  ///< their positions
  float along[3];          ///< unit, from a to b
  float outward[3];        ///< unit, towards the half-space beyond plane beta
  float length;            ///< |ab|
  float longest;           ///< maximum edge length at a and b
  float reach;             ///< maximum distance from the middle
  const float* longest_at; ///< maximum edge length in each leaf
  std::int32_t leaf;       ///< where the walk begins
  /** Bits of the points of each leaf that are excluded as apexes, for the leaves from
   * first_masked to before end_masked; the other leaves have no mask. */
  const std::uint16_t* masks;
  std::int32_t first_masked, end_masked;
};

/** \brief A search for points inside a ball. */
struct BallQuery {
  std::int32_t corners[3]; ///< on its surface, excluded from the result
  float origin[3];         ///< a position near the ball, exact
  float centre[3];         ///< centre relative to origin
  float middle[3];         ///< centre of the ball, rounded
  float radius;
  std::int32_t leaf; ///< where the walk begins
};

/** \brief Candidates found by a search; the decision between them is made in double
 * precision. */
struct SearchHits {
  static constexpr std::int32_t capacity = 64;
  std::int32_t count = 0;  ///< capacity + 1: there are more
  bool is_decided = false; ///< the only hit is the result
  std::int32_t index[capacity];
};

/** \brief Finds candidates, including each permitted point with the largest angle. */
void
findApexCandidates(const TreeCells& tree, const ApexQuery& query, SearchHits& hits);

/** \brief Finds candidates, including the point whose circle through a and b is the
 * smallest, at least among the points within the reach; their distances from a and b
 * are not limited. */
void
findCircleCandidates(const TreeCells& tree, const ApexQuery& query, SearchHits& hits);

/** \brief Returns true if a point is certainly inside. If false, only the hits may be
 * inside. */
bool
findInBall(const TreeCells& tree, const BallQuery& query, SearchHits& hits);

} // namespace pcl::acmap::ACMAP_DEWALL
