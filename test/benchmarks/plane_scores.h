#pragma once

#include "plane_finders.h"
#include "plane_truth.h"

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief Number of planes with points, and how many of them were found. */
struct FoundShare {
  std::size_t found = 0;
  std::size_t there = 0;
};

/** \brief Deviations of detected planes; offsets are at the centroid of the true
 * plane's points. NaN if none was found. */
struct PlaneErrors {
  double largest_angle = 0; ///< degrees
  double mean_angle = 0;
  double largest_offset = 0; ///< metres
  double mean_offset = 0;
};

/** \brief Quality of a plane detection. A true plane counts as found if a detected
 * plane has most of its points from it, and deviates by less than \ref MatchLimits. */
struct PlaneScores {
  FoundShare main;  ///< floor, ceiling, walls, ends
  FoundShare doors; ///< planes of doors
  FoundShare large; ///< all planes with at least \ref largeCount points
  FoundShare all;
  std::size_t given = 0;      ///< detected planes, correct or not
  std::size_t spurious = 0;   ///< less than half from one true plane, or too large a
                              ///< deviation
  std::size_t duplicates = 0; ///< of planes that were found with more points
  PlaneErrors main_errors;
  PlaneErrors all_errors;
  double large_labels = 0; ///< correctly labelled points of main, door and large
                           ///< planes, %
  double all_labels = 0;   ///< correctly labelled points of all planes, %
  double precision = 0;    ///< points assigned to a plane that belong to it, %
  double seconds = 0;
};

PlaneScores
scorePlanes(const PlaneCase& plane_case, const FoundPlanes& found);

} // namespace pcl::acmap::bench
