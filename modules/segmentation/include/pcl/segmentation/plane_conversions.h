#pragma once

#include <pcl/ModelCoefficients.h>
#include <pcl/PointIndices.h>
#include <pcl/core/export.h>
#include <pcl/core/plane_patch.h>
#include <pcl/segmentation/planar_region.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {

/** \brief The plane as PCL's plane models have it: four values a, b, c, d with
 * a x + b y + c z + d = 0, metres.
 * \param[in] patch frame of the cloud
 * \param[out] coefficients its header stays as it is \ingroup segmentation */
ACMAP_EXPORT void
toModelCoefficients(const PlanePatch& patch, ModelCoefficients& coefficients);

namespace acmap {

/** \brief Covariance of points spread evenly over the polygons of a patch, as far off the
 * plane as its support is: square metres. Not what PlanePatch calls its covariance, which
 * tells how surely the plane lies where it does. \ingroup segmentation */
ACMAP_EXPORT Eigen::Matrix3d
spreadOf(const PlanePatch& patch);

/** \brief The points of each plane, from the plane of each point (-1 for none). */
ACMAP_EXPORT std::vector<PointIndices>
clustersOf(const std::vector<std::int32_t>& labels,
           std::size_t planes,
           const PCLHeader& header);

/** \brief Rim of the largest polygon, empty where there is none. */
ACMAP_EXPORT std::vector<Eigen::Vector3f>
largestRim(const PlanePatch& patch);

} // namespace acmap

/** \brief The plane as PCL's organized segmentation gives it.
 *
 * Contour is the rim of the largest polygon, count the support, centroid the middle of the
 * support. PCL's covariance is that of the points: see \ref acmap::spreadOf. Holes, other
 * polygons and the uncertainty of the plane get lost.
 * \param[in] patch frame of the cloud, metres
 * \param[out] region fields of a contour's points other than x, y, z are those of a
 * default-constructed one \ingroup segmentation */
template <typename PointT>
void
toPlanarRegion(const PlanePatch& patch, PlanarRegion<PointT>& region)
{
  typename PointCloud<PointT>::VectorType contour;
  for (const Eigen::Vector3f& place : acmap::largestRim(patch)) {
    PointT point;
    point.getVector3fMap() = place;
    contour.push_back(point);
  }
  const Eigen::Matrix3d spread = acmap::spreadOf(patch);
  constexpr std::size_t most = std::numeric_limits<unsigned>::max();
  region = PlanarRegion<PointT>(patch.center.cast<float>(),
                                spread.cast<float>(),
                                static_cast<unsigned>(std::min(patch.support, most)),
                                contour,
                                patch.coefficients.cast<float>());
  const double thickness = patch.rms * patch.rms;
  region.setCurvature(thickness > 0 ? static_cast<float>(thickness / spread.trace())
                                    : 0.0F);
}

} // namespace pcl
