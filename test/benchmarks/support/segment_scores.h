#pragma once

#include "plane_overlaps.h"

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief Comparison of two plane segmentations after Hoover et al. 1996, at 80 %
 * overlap. Points without a true plane are not evaluated: they do not count for the
 * size of a detected plane, and a detected plane that mostly consists of them is not
 * noise. */
struct SegmentScores {
  std::size_t truths = 0;        ///< true planes
  std::size_t large = 0;         ///< of these, those with \ref largeCount points
  std::size_t given = 0;         ///< detected planes
  std::size_t correct = 0;       ///< true planes that match one detected plane
  std::size_t correct_large = 0; ///< of these, large ones
  std::size_t over = 0;          ///< true planes split into several detected ones
  std::size_t under = 0;         ///< detected planes that merge several true ones
  std::size_t missed = 0;        ///< true planes in none of these categories
  std::size_t noise = 0;         ///< detected planes in none of these categories

  /** \brief Percentage of the points of true planes that are in the detected plane that
   * has most of their plane's points and mostly consists of them. */
  double labels = 0;
};

SegmentScores
scoreSegments(const PlaneOverlaps& overlaps, std::size_t large_count);

} // namespace pcl::acmap::bench
