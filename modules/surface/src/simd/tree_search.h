#pragma once

#include "tree_cells.h"

namespace pcl::acmap::dewall {

/** \brief A search for the apex over a side a b, in float: the points whose angle apb may
 * be the largest, up to a margin above all rounding. Doubles decide between them. */
struct ApexQuery {
  std::int32_t a, b;       ///< of the side, never found
  std::int32_t left_out;   ///< never found either; -1: none
  float at_a[3], at_b[3];  ///< their positions
  float along[3];          ///< unit, from a to b
  float outward[3];        ///< unit, beyond plane beta
  float length;            ///< |ab|
  float longest;           ///< edge allowed at a and b
  float reach;             ///< farthest from the middle that it allows
  const float* longest_at; ///< edge allowed at the points of each leaf
  std::int32_t leaf;       ///< where the walk begins
  /** Bits of the points of each leaf that are no apexes, for leaves from first_masked to
   * end_masked; elsewhere nothing is masked. */
  const std::uint16_t* masks;
  std::int32_t first_masked, end_masked;
};

/** \brief A search for points inside a ball. */
struct BallQuery {
  std::int32_t corners[3]; ///< on its surface, never found
  float origin[3];         ///< a position near the ball, exact
  float centre[3];         ///< from there
  float middle[3];         ///< centre of the ball, rounded
  float radius;
  std::int32_t leaf; ///< where the walk begins
};

/** \brief What a search found: the answer for doubles to choose from. */
struct SearchHits {
  static constexpr std::int32_t capacity = 64;
  std::int32_t count = 0; ///< capacity + 1: more than fit
  std::int32_t index[capacity];
};

/** \brief The searches that take most of the time, in variants for processors. All give
 * hits that lead to the same answer. */
struct TreeSearch {
  /** Candidates, among them every allowed point of largest angle. */
  void (*apexes)(const TreeCells&, const ApexQuery&, SearchHits&);

  /** \brief True: a point lies inside for sure. False: only the hits may. */
  bool (*ball)(const TreeCells&, const BallQuery&, SearchHits&);
};

extern const TreeSearch tree_search_base;
#ifdef ACMAP_SIMD_AVX2
extern const TreeSearch tree_search_avx2;
#endif

/** \brief The variant for this processor, or what the environment variable ACMAP_SIMD
 * names ("base"). */
const TreeSearch&
treeSearch();

} // namespace pcl::acmap::dewall
