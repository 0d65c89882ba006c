#pragma once

#include "plane_finders.h"
#include "plane_truth.h"

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief How many of the planes that have points were found. */
struct FoundShare {
  std::size_t found = 0;
  std::size_t there = 0;
};

/** \brief What found planes deviate by; offsets are those at the centroid of the true
 * plane's points. NaN where none was found. */
struct PlaneErrors {
  double largest_angle = 0; ///< degrees
  double mean_angle = 0;
  double largest_offset = 0; ///< metres
  double mean_offset = 0;
};

/** \brief How well planes were found. A true plane is found when a found plane has most of
 * its points from it and deviates from it by less than \ref PlaneLimits. */
struct PlaneScores {
  FoundShare main;  ///< floor, ceiling, walls, ends
  FoundShare doors; ///< planes of doors
  FoundShare large; ///< all planes with at least \ref largeCount points
  FoundShare all;
  std::size_t given = 0;      ///< found planes, right or not
  std::size_t spurious = 0;   ///< less than half from one true plane, or too far off it
  std::size_t duplicates = 0; ///< of planes that are found by more points already
  PlaneErrors main_errors;
  PlaneErrors all_errors;
  double large_labels = 0; ///< points of main, door and large planes labelled right, %
  double all_labels = 0;   ///< points of all planes labelled right, %
  double precision = 0;    ///< points given to a plane that belong to it, %
  double seconds = 0;
};

PlaneScores
scorePlanes(const PlaneCase& plane_case, const FoundPlanes& found);

} // namespace pcl::acmap::bench
