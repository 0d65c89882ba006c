#pragma once

#include "simulated_clouds.h"

#include <map>

namespace pcl::acmap::bench {

/** \brief The true noise of a simulated cloud, metres: each point is compared with the
 * plane that its label names. */
struct NoiseTruth {
  /** \brief Median over the surface of the standard deviation across it, in square cells
   * of 10 cm, or of as much as it takes to hold 16 points on average; those with less
   * than 9 are left out. */
  double sigma = 0;

  double spacing = 0; ///< root of the visible area over the points

  /** \brief Root mean square along the ray, by distance to the sensor; bins as those of
   * NoiseScale, each under twice the binary logarithm of its least distance. */
  std::map<int, double> ranges;
};

/** \brief The bin of a distance, metres. */
int
rangeBin(double distance);

NoiseTruth
measureTruth(const SimulatedCloud& cloud, double visible_area);

} // namespace pcl::acmap::bench
