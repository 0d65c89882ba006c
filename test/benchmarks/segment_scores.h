#pragma once

#include "plane_overlaps.h"

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief How two segmentations into planes agree, after Hoover et al. 1996, at 80 %
 * overlap. Points without a true plane are not judged: they do not count for the size of
 * a found plane, and a found plane that mostly consists of them is no noise. */
struct SegmentScores {
  std::size_t truths = 0;        ///< true planes
  std::size_t large = 0;         ///< of these, the ones with \ref largeCount points
  std::size_t given = 0;         ///< found planes
  std::size_t correct = 0;       ///< true planes that one found plane equals
  std::size_t correct_large = 0; ///< of these, large ones
  std::size_t over = 0;          ///< true planes that several found ones make up
  std::size_t under = 0;         ///< found planes that several true ones make up
  std::size_t missed = 0;        ///< true planes in none of the above
  std::size_t noise = 0;         ///< found planes in none of the above

  /** \brief Points of true planes in the found plane that has most of theirs and is
   * mostly theirs, percent. */
  double labels = 0;
};

SegmentScores
scoreSegments(const PlaneOverlaps& overlaps, std::size_t large_count);

} // namespace pcl::acmap::bench
