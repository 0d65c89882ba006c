#pragma once

#include <pcl/core/export.h>
#include <pcl/core/point_view.h>
#include <pcl/core/sensor_view.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief How noisy a cloud of surfaces is, and how dense: the two lengths from which
 * all automatic sizes follow. \ingroup core */
struct NoiseScale {
  /** \brief Standard deviation of the points across their surface, in metres; the middle
   * of what the surface shows. 0 when no noise can be told from the shape. */
  double sigma = 0;

  /** \brief Side of the square of surface that holds one point, in metres, on average: the
   * root of the surface's area over the number of points. 0 when there is no surface. */
  double spacing = 0;

  /** \brief The same where points are sparse: exceeded on a quarter of the surface. */
  double sparse_spacing = 0;

  /** \brief From 0 to 1: the share of the surface that is plane enough to measure on,
   * times the share of its thickness there that does not grow with the scale. */
  double confidence = 0;

  /** \brief Noise along the ray of points that one sensor distance away saw. */
  struct Range {
    double distance = 0; ///< to the sensor, metres; the geometric middle of the bin
    double sigma = 0;    ///< standard deviation along the ray, metres
    std::size_t points = 0;
  };

  /** \brief Bins of a factor of sqrt (2), ascending; empty where no sensor is known. */
  std::vector<Range> ranges;

  /** \brief Noise of the depth of one organized view, which is even in inverse depth for
   * cameras that triangulate. All in 1/m; a depth z has z^2 times it in metres. */
  struct InverseDepth {
    double step = 0;        ///< the sensor's rounding; 0: not quantised
    double independent = 0; ///< standard deviation of a pixel about its neighbours
    double correlated = 0;  ///< what pixels share with others over tens of pixels

    /** \brief Standard deviation of a pixel. */
    double
    sigma() const
    {
      return std::sqrt(independent * independent + correlated * correlated);
    }
  };

  /** \brief Where the cloud is one view whose depth is quantised. */
  std::optional<InverseDepth> inverse_depth;

  /** \brief Why there is no answer, or a doubtful one. */
  std::vector<std::string> remarks;

  bool
  hasNoise() const
  {
    return sigma > 0;
  }
};

namespace acmap {

/** \brief Measures sigma and spacing on planes through windows of 3 x 3 x 3 voxels,
 * at the smallest scale that holds the noise.
 *
 * Voxels of 3 to 64 points, by the size of the cloud, are summed once and doubled; at each
 * scale the thickness is the mean of the middle half of the planar windows. The
 * scale is the first one whose voxel is three times as large as the thickness, and at
 * whose double the thickness is much the same; what it grows is taken for curvature and
 * removed. Linear time, memory of the voxels.
 *
 * Points in their sensor's frame whose depth is quantised (\ref measureDepthStep) have the
 * noise of their steps: sigma and the ranges are then z^2 times that of inverse depth.
 * \param[in] points metres
 * \param[in] sensors who saw them; without it there are no ranges
 * \param[in] threads 0 for all; the answer is the same
 * \param[in] width pixels of a row where the points are one organized view, whose noise is
 * then measured in its picture; 0 for other clouds */
ACMAP_EXPORT NoiseScale
measureNoiseScale(const PointView& points,
                  const SensorView& sensors,
                  unsigned threads = 0,
                  std::size_t width = 0);

} // namespace acmap
} // namespace pcl
