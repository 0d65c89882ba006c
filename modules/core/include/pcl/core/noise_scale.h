#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/sensor_view.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Noise and density of a cloud of surfaces: the two lengths from which all
 * automatic sizes are derived. \ingroup core */
struct NoiseScale {
  /** \brief Standard deviation of the points across their surface, in metres; the
   * typical value over the surface. 0 if the noise cannot be distinguished from the
   * shape. */
  double sigma = 0;

  /** \brief 95 % interval of \ref sigma, metres; none without noise, or if it is that of
   * steps of the depth. */
  std::optional<std::array<double, 2>> interval;

  /** \brief Side of the square of surface per point, in metres, on average: the square
   * root of the area of the surface over the number of points. 0 if there is no
   * surface. */
  double spacing = 0;

  /** \brief Spacing in sparse regions: it is exceeded on a quarter of the surface. */
  double sparse_spacing = 0;

  /** \brief From 0 to 1: the share of the surface that is planar enough for the
   * measurement, times the share of its thickness that does not grow with the scale. */
  double confidence = 0;

  /** \brief Noise along the ray of the points at one distance from the sensor. */
  struct Range {
    /** \brief Distance to the sensor, metres; geometric mean of the bin limits. */
    double distance = 0;
    double sigma = 0; ///< standard deviation along the ray, metres
    std::size_t points = 0;
  };

  /** \brief Bins whose limits differ by a factor of sqrt (2), ascending; empty if no
   * sensor is known. */
  std::vector<Range> ranges;

  /** \brief Depth noise of one organized view, which is uniform in inverse depth for
   * sensors that triangulate. All values are in 1/m; multiply by z^2 for the noise of a
   * depth z in metres. */
  struct InverseDepth {
    double step = 0; ///< quantisation step of the sensor; 0: not quantised
    /** \brief Standard deviation of the part that is independent between pixels. */
    double independent = 0;
    /** \brief Standard deviation of the part shared over tens of pixels. */
    double correlated = 0;

    /** \brief Standard deviation of the pixels at one inverse depth. */
    struct AtDepth {
      double inverse_depth = 0; ///< 1/m
      double sigma = 0;         ///< 1/m
    };

    /** \brief If the depth is not quantised and the noise is independent between pixels:
     * its standard deviation by ascending inverse depth, which need not be uniform.
     * Otherwise empty. */
    std::vector<AtDepth> by_depth;

    /** \brief Standard deviation of the inverse depth of a pixel. */
    double
    sigma() const
    {
      return std::sqrt(independent * independent + correlated * correlated);
    }

    /** \brief Is the noise independent between pixels, so that \ref by_depth is known? */
    bool
    isIndependent() const
    {
      return !by_depth.empty();
    }
  };

  /** \brief Set if the cloud is one view whose depth is quantised. */
  std::optional<InverseDepth> inverse_depth;

  /** \brief false if the surface shows too little to tell noise from shape; sigma is then
   * 0, and nothing should follow from it. */
  bool is_determined = true;

  /** \brief Reasons why there is no result or an uncertain one. */
  std::vector<std::string> remarks;

  bool
  hasNoise() const
  {
    return sigma > 0;
  }
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const NoiseScale& scale, Visitor&& visit)
{
  visit({"sigma", "m"}, scale.sigma);
  visit({"interval", "m"}, scale.interval);
  visit({"spacing", "m"}, scale.spacing);
  visit({"sparse_spacing", "m"}, scale.sparse_spacing);
  visit({"confidence"}, scale.confidence);
  visit({"is_determined"}, scale.is_determined);
  visit({"ranges"}, scale.ranges);
  visit({"inverse_depth"}, scale.inverse_depth);
  visit({"remarks"}, scale.remarks);
}

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const NoiseScale::Range& range, Visitor&& visit)
{
  visit({"distance", "m"}, range.distance);
  visit({"sigma", "m"}, range.sigma);
  visit({"points"}, range.points);
}

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const NoiseScale::InverseDepth& noise, Visitor&& visit)
{
  visit({"step", "1/m"}, noise.step);
  visit({"independent_sigma", "1/m"}, noise.independent);
  visit({"correlated_sigma", "1/m"}, noise.correlated);
  visit({"by_depth"}, noise.by_depth);
}

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const NoiseScale::InverseDepth::AtDepth& noise, Visitor&& visit)
{
  visit({"inverse_depth", "1/m"}, noise.inverse_depth);
  visit({"sigma", "1/m"}, noise.sigma);
}

namespace acmap {

/** \brief Measures sigma and spacing by planes fitted to windows of 3 x 3 x 3 voxels,
 * at the smallest scale whose voxels are larger than the noise.
 *
 * The voxels contain 3 to 64 points, depending on the size of the cloud; they are
 * summed once, and their edge is doubled from scale to scale. At each scale the
 * thickness is the mean of the middle half of the planar windows. The chosen scale is
 * the first one whose voxel is three times as large as the thickness, and at whose
 * double the thickness is similar; its growth is attributed to curvature and removed.
 * Takes linear time, and memory for the voxels.
 *
 * For points in the frame of their sensor with quantised depth (measureDepthStep)
 * the noise follows from the quantisation step: sigma and the ranges are then z^2 times
 * the noise of inverse depth.
 *
 * A sigma above 0.2 m or 2 % of the extent, or above 2 cm between points that are more than
 * 0.1 m apart, of which less than two thirds of the windows are sure, is verified by
 * measureSurfaceNoise, which does not take the storeys of a building for thick planes:
 * its result is taken if it contradicts by more than a factor of three, and if it is not
 * determined, neither is this one. Where many points are (0, 0, 0), as invalid ones of some
 * programs are, these are left out, and there are no ranges.
 * \param[in] points metres
 * \param[in] sensors sensor positions; without them no ranges are computed
 * \param[in] threads 0 for all; the result is the same
 * \param[in] width pixels per row if the points are one organized view, whose noise is
 * then measured in the image; 0 for other clouds */
ACMAP_EXPORT NoiseScale
measureNoiseScale(const PointView& points,
                  const SensorView& sensors,
                  unsigned threads = 0,
                  std::size_t width = 0);

} // namespace acmap
} // namespace pcl
