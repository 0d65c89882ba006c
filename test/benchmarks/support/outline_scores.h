#pragma once

#include "map_outlines.h"
#include "visible_truth.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief How outlines agree with the visible truth. Lengths in metres, areas in square
 * metres. */
struct OutlineScores {
  /** \brief Plane of the truth for each plane of the map, -1 for none: the face with
   * the largest part of its outline, if that is at least half of it, the normals are
   * within 5 degrees and the corners within 3 cm of the true plane on average. */
  std::vector<std::int32_t> face_of_plane;
  double unmatched_area = 0; ///< of planes without a face

  double creases = 0; ///< see VisibleTruth::creases
  /** \brief Of these, both faces have planes of the map whose outlines are within 0.5 m:
   * a face may consist of several parts. */
  double found = 0;
  double shared = 0; ///< of these, within 1 cm of an edge that both planes have
  double gaps = 0;   ///< of the found, an outline ends more than 1 cm away

  // of the faces that have planes of the map
  double seen = 0;
  double common = 0;         ///< seen and inside an outline
  double joined = 0;         ///< seen or inside an outline
  double missing = 0;        ///< seen, but outside of the outlines
  double missing_inside = 0; ///< of it, more than 5 cm from where nothing was seen
  double unseen = 0;         ///< inside an outline, on the face, but not seen
  double nothing = 0;        ///< inside an outline, where there is no surface
  double nothing_inside = 0; ///< of it, more than 5 cm from the face

  /** \brief Distances of the true corners from the nearest vertex, at most 0.5. */
  std::vector<double> corners;
};

/** \param[in] outlines in the frame of the truth */
OutlineScores
scoreOutlines(const std::vector<PlaneOutline>& outlines, const VisibleTruth& truth);

} // namespace pcl::acmap::bench
