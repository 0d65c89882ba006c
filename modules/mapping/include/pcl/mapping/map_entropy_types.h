#pragma once

#include <pcl/core/report.h>

#include <cstddef>

namespace pcl {

/** \brief The entropy of a map (Eq. 3) and its terms, in bits. \ingroup mapping */
struct MapEntropyTerms {
  double total = 0; ///< joint + mu (along_x + along_z)
  double joint = 0; ///< H(q_XZ); with directions H(q_XZK)
  double along_x = 0;
  double along_z = 0;

  /** That were counted, whatever they weigh; 0: all terms are 0 and mean nothing. */
  std::size_t points = 0;

  /** In how many directions of the XZ plane the points lie apart: 0 in one place, 1
   * on a line, 2. Below 2 no pose is determined. */
  int dimensions = 0;
};

/** \brief What MapEntropy tells about its last run. \ingroup mapping */
struct MapEntropyReport : Report {
  std::size_t observations = 0;
  std::size_t points = 0;          ///< of all observations
  std::size_t invalid_points = 0;  ///< not finite, skipped
  std::size_t distant_points = 0;  ///< 1e9 m and more from their sensor
  std::size_t directed_points = 0; ///< with the direction of a wall
  std::size_t cells = 0; ///< that stood for the points; 0 where each one was counted
  std::size_t bins_x = 0, bins_z = 0, layers = 0; ///< of the grid, margins included
};

} // namespace pcl
