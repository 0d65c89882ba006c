#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>

#include <cstddef>
#include <string>

namespace pcl::acmap {

/** \brief Noise of a cloud of surfaces with its interval, by places that each tell it
 * alone. Metres. \ingroup core */
struct SurfaceNoise {
  bool is_determined = false;
  std::string reason; ///< why it is not
  /** \brief Standard deviation across the surface; 0 if it is not determined, or too small
   * to be told from nothing. */
  double sigma = 0;
  double low = 0, high = 0; ///< 95 % interval of \ref sigma
  double spacing = 0;       ///< side of the square of surface for each point
  std::size_t places = 0;   ///< that were asked
  std::size_t answers = 0;  ///< that told a noise
  std::size_t members = 0;  ///< whose answers agree
};

/** \brief Asks some 2,000 places of the surface, uniform over its area, for the residuals
 * of planes and quadrics in windows that grow until three in a row agree, and takes the
 * mode of their answers. A place at an edge, on a line or in a thicket says nothing; where
 * too few places answer, the noise is not determined.
 * \param[in] points what is not finite, repeated or at the origin is left out
 * \param[in] threads 0 for all; the result is the same, and does not depend on the order of
 * the points */
ACMAP_EXPORT SurfaceNoise
measureSurfaceNoise(const PointView& points, unsigned threads = 0);

} // namespace pcl::acmap
