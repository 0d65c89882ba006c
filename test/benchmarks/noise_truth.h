#pragma once

#include "simulated_clouds.h"

#include <map>

namespace pcl::acmap::bench {

/** \brief The true noise of a simulated cloud, metres: each point is compared with the
 * plane of its label. */
struct NoiseTruth {
  /** \brief Median over the surface of the standard deviation across it, in square
   * cells of 10 cm, or larger ones if needed for 16 points on average; cells with
   * fewer than 9 points are ignored. */
  double sigma = 0;

  double spacing = 0; ///< square root of the visible area per point

  /** \brief RMS along the ray, by distance to the sensor. The bins are those of
   * NoiseScale, with twice the binary logarithm of their minimum distance as key. */
  std::map<int, double> ranges;
};

/** \brief The bin of a distance in metres. */
int
rangeBin(double distance);

NoiseTruth
measureTruth(const SimulatedCloud& cloud, double visible_area);

} // namespace pcl::acmap::bench
