#include "tree_search.h"

#include "tree_walk.h"

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

constexpr float unbounded = __builtin_inff();

/** Returns the cotangent, given its signed square. */
ACMAP_INLINE float
cotangentOf(float signed_square)
{
  return signed_square < 0 ? -__builtin_sqrtf(-signed_square)
                           : __builtin_sqrtf(signed_square);
}

/** Tests points as apexes, in units of the edge length: the angle apb is largest where
 * the signed square of its cotangent, (a - p) . (b - p) |(a - p) . (b - p)| / |u x (p -
 * a)|^2, is minimal; the circle abp is smallest where the square without its sign is. A
 * point is *sure* if it is permitted regardless of rounding: only such points lower the
 * limit for the others.
 * \param OfCircles selects the smallest circle, without a limit of the edge length */
template <bool OfCircles>
struct ApexVisitor {
  const TreeCells& tree;
  const ApexQuery& query;
  SearchHits& hits;
  Ball ball;
  float scale;
  float* score;            ///< of each hit
  float best = unbounded;  ///< minimum of the sure ones
  float limit = unbounded; ///< upper limit of candidates

  ACMAP_INLINE unsigned
  keep(int level, std::int32_t group) const
  {
    return membersBeyond(tree.boxes[level][group], query.at_a, query.outward);
  }

  ACMAP_INLINE void
  raiseBar(float signed_square)
  {
    best = signed_square;
    const float cotangent = cotangentOf(best);
    const float size = cotangent < 0 ? -cotangent : cotangent;
    const float bar = cotangent + 1e-4f * (1 + size);
    limit = bar < 0 ? -bar * bar : bar * bar;
    // All better apexes are in balls through a and b, hence within this distance of the
    // middle.
    const float half = query.length / 2;
    const float radius = bar > 0 ? half * (bar + __builtin_sqrtf(bar * bar + 1)) : half;
    ball.radius = radius < ball.radius ? radius : ball.radius;
  }

  /** Removes the hits above the limit. */
  void
  prune()
  {
    std::int32_t kept = 0;
    for (std::int32_t i = 0; i < hits.count; ++i)
      if (score[i] <= limit) {
        score[kept] = score[i];
        hits.index[kept++] = hits.index[i];
      }
    hits.count = kept;
  }

  ACMAP_INLINE void
  note(std::int32_t index, float signed_square)
  {
    if (hits.count == SearchHits::capacity)
      prune();
    if (hits.count >= SearchHits::capacity) {
      hits.count = SearchHits::capacity + 1;
      ball.radius = -1;
      return;
    }
    score[hits.count] = signed_square;
    hits.index[hits.count++] = index;
  }

  ACMAP_INLINE void
  lookAt(std::int32_t first, unsigned alive, float longest)
  {
    const Lanes unit = allLanes(scale);
    Lanes a2 = allLanes(0), b2 = a2, dot = a2, forward = a2;
    Lanes v[3];
    for (int axis = 0; axis < 3; ++axis) {
      const Lanes p = loadLanes(tree.coordinates[axis] + first);
      v[axis] = (p - allLanes(query.at_a[axis])) * unit;
      const Lanes t = (p - allLanes(query.at_b[axis])) * unit;
      a2 += v[axis] * v[axis];
      b2 += t * t;
      dot += v[axis] * t;
      forward += v[axis] * allLanes(query.outward[axis]);
    }
    const Lanes ux = allLanes(query.along[0]), uy = allLanes(query.along[1]),
                uz = allLanes(query.along[2]);
    const Lanes cx = uy * v[2] - uz * v[1], cy = uz * v[0] - ux * v[2],
                cz = ux * v[1] - uy * v[0];
    const Lanes cross2 = cx * cx + cy * cy + cz * cz;
    const Lanes square = dot * (OfCircles ? dot : maxLanes(dot, -dot)) / cross2;
    const Lanes far2 = maxLanes(a2, b2);
    const Lanes doubt = allLanes(1e-6f) * (allLanes(1) + a2);
    const float sides = longest * scale, limit2 = sides * sides;
    const LaneMask maybe = (square <= allLanes(limit)) & (forward > -doubt) &
                           (far2 <= allLanes(limit2 * (1 + 1e-5f)));
    unsigned candidates = bitsOf(maybe) & alive;
    if (!candidates)
      return;
    const LaneMask certain = (forward > doubt) &
                             (far2 <= allLanes(limit2 * (1 - 1e-5f))) &
                             (cross2 > allLanes(1e-6f) * far2);
    const unsigned sure = bitsOf(certain);
    alignas(32) float values[8];
    __builtin_memcpy(values, &square, sizeof values);
    while (candidates) { // the least one first: it excludes most of the others
      const unsigned lane = candidates & (candidates - 1)
                                ? smallestLane(square, candidates)
                                : lowestBit(candidates);
      candidates &= ~(1u << lane);
      const std::int32_t index = first + static_cast<std::int32_t>(lane);
      if (index == query.a || index == query.b || index == query.left_out)
        continue;
      if ((sure >> lane & 1u) && values[lane] < best) {
        raiseBar(values[lane]);
        candidates &= bitsOf(square <= allLanes(limit));
      }
      note(index, values[lane]);
    }
  }

  ACMAP_INLINE void
  visit(std::int32_t leaf)
  {
    const std::int32_t first = firstOfLeaf(tree, leaf);
    const std::int32_t size = firstOfLeaf(tree, leaf + 1) - first;
    unsigned alive = (1u << size) - 1;
    if (leaf >= query.first_masked && leaf < query.end_masked)
      alive &= ~static_cast<unsigned>(query.masks[leaf]);
    if (!alive)
      return;
    float longest = unbounded;
    if (!OfCircles) {
      const float here = query.longest_at[leaf];
      longest = here < query.longest ? here : query.longest;
    }
    lookAt(first, alive & 0xff, longest);
    if (alive >> 8)
      lookAt(first + 8, alive >> 8, longest);
  }
};

template <bool OfCircles>
void
findCandidates(const TreeCells& tree, const ApexQuery& query, SearchHits& hits)
{
  float middle[3];
  for (int axis = 0; axis < 3; ++axis)
    middle[axis] = query.at_a[axis] + query.along[axis] * (query.length / 2);
  hits.count = 0;
  float score[SearchHits::capacity];
  ApexVisitor<OfCircles> visitor{tree,
                                 query,
                                 hits,
                                 ballAt(middle, query.reach * (1 + 1e-5f)),
                                 1 / query.length,
                                 score};
  walkTree(tree, visitor, query.leaf);
  if (hits.count <= SearchHits::capacity)
    visitor.prune();
  hits.is_decided = hits.count == 1 && visitor.best < unbounded;
}

/** Uses the radius as unit: squares in metres exceed the range of floats below 1e-19
 * and above 1e19. */
struct BallVisitor {
  const TreeCells& tree;
  const BallQuery& query;
  SearchHits& hits;
  Ball ball;
  float scale;
  bool is_occupied = false;

  ACMAP_INLINE unsigned
  keep(int, std::int32_t) const
  {
    return 0xff;
  }

  ACMAP_INLINE void
  lookAt(std::int32_t first, unsigned alive)
  {
    Lanes squared = allLanes(0);
    for (int axis = 0; axis < 3; ++axis) {
      const Lanes v =
          (loadLanes(tree.coordinates[axis] + first) - allLanes(query.origin[axis])) -
          allLanes(query.centre[axis]);
      const Lanes radii = v * allLanes(scale);
      squared += radii * radii;
    }
    if (bitsOf(squared < allLanes(1 - 1e-4f)) & alive) {
      is_occupied = true;
      ball.radius = -1;
      return;
    }
    unsigned candidates = bitsOf(squared < allLanes(1 + 1e-4f)) & alive;
    for (; candidates; candidates &= candidates - 1) {
      const std::int32_t index =
          first + static_cast<std::int32_t>(lowestBit(candidates));
      if (index == query.corners[0] || index == query.corners[1] ||
          index == query.corners[2])
        continue;
      if (hits.count >= SearchHits::capacity) {
        hits.count = SearchHits::capacity + 1;
        ball.radius = -1;
        return;
      }
      hits.index[hits.count++] = index;
    }
  }

  ACMAP_INLINE void
  visit(std::int32_t leaf)
  {
    const std::int32_t first = firstOfLeaf(tree, leaf);
    const unsigned alive = (1u << (firstOfLeaf(tree, leaf + 1) - first)) - 1;
    lookAt(first, alive & 0xff);
    if (alive >> 8 && !is_occupied)
      lookAt(first + 8, alive >> 8);
  }
};

} // namespace

void
findApexCandidates(const TreeCells& tree, const ApexQuery& query, SearchHits& hits)
{
  findCandidates<false>(tree, query, hits);
}

void
findCircleCandidates(const TreeCells& tree, const ApexQuery& query, SearchHits& hits)
{
  findCandidates<true>(tree, query, hits);
}

bool
findInBall(const TreeCells& tree, const BallQuery& query, SearchHits& hits)
{
  hits.count = 0;
  BallVisitor visitor{tree,
                      query,
                      hits,
                      ballAt(query.middle, query.radius * (1 + 1e-4f)),
                      1 / query.radius};
  walkTree(tree, visitor, query.leaf);
  return visitor.is_occupied;
}

} // namespace pcl::acmap::ACMAP_DEWALL
