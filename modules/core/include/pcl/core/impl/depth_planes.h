#pragma once

#include <pcl/core/impl/depth_view.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/progress.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Parameters of \ref findDepthPlanes. \ingroup core */
struct DepthPlaneSettings {
  NoiseScale::InverseDepth noise;

  /** \brief Minimum area of a plane, square metres. 0 for automatic: 0.1, or 0.3 % of
   * the visible surface if that is less. */
  double min_area = 0;
};

/** \brief A plane of a view. */
struct DepthPlane {
  /** \brief (a, b, c) of 1/z = a x + b y + c, 1/m: the normal of the plane, which
   * points away from the sensor, divided by its distance. */
  Eigen::Vector3d inverse = Eigen::Vector3d::Zero();

  double rms = 0;  ///< of the residuals of its pixels in inverse depth, 1/m
  double area = 0; ///< square metres of the plane that its pixels cover
  std::size_t pixels = 0;

  Eigen::Vector3d
  normal() const
  {
    return inverse.normalized();
  }

  /** \brief Distance from the sensor, metres. */
  double
  distance() const
  {
    return 1 / inverse.norm();
  }
};

struct DepthPlanes {
  std::vector<DepthPlane> planes; ///< in descending order of area
  PointLabels labels;             ///< index of the plane of each pixel, -1 for none
  /** \brief Number of regions that were merged into another plane. */
  std::size_t merged = 0;
  /** \brief Number of regions that are too small or whose tilt is uncertain. */
  std::size_t small = 0;
  /** \brief Number of regions that are strips of a curved surface. */
  std::size_t curved = 0;
};

/** \brief Finds the planes of a depth view in image space, where the noise of inverse
 * depth is uniform.
 *
 * The moments of (x, y, 1/z) are computed for tiles of 8 x 8 pixels. Blocks of 6, 4, 3
 * and 2 tiles in width that are planar within the noise are seeds, starting with the
 * largest blocks. A region grows over the neighbouring tiles that fit its plane, which
 * is refitted during growth. Regions of the same plane are then merged, even if they
 * are not connected. Each pixel is finally assigned to the plane that it fits. Where
 * two planes meet, it is assigned to the front plane at a concave edge and to the rear
 * plane at a convex edge, regardless of their noise. The algorithm takes linear time,
 * is deterministic and uses a single thread. */
ACMAP_EXPORT DepthPlanes
findDepthPlanes(const DepthView& view,
                const DepthPlaneSettings& settings,
                const Progress& progress);

/** \brief Converts planes that were found before. Only their equations and the labels
 * of the pixels are set; the other fields stay empty.
 * \param[in] patches in the frame of the sensor; none passes through the sensor
 * \param[in] labels for each pixel the index of its patch, -1 for none
 * \throws BadArgumentException if a label is not the index of a patch, or a plane
 * passes through the sensor */
ACMAP_EXPORT DepthPlanes
depthPlanesOf(const std::vector<PlanePatch>& patches, const PointLabels& labels);

} // namespace pcl::acmap
