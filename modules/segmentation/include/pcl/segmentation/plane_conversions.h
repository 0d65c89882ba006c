#pragma once

#include <pcl/ModelCoefficients.h>
#include <pcl/PointIndices.h>
#include <pcl/core/export.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/segmentation/planar_region.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {

/** \brief Converts a plane to PCL's plane model: four values a, b, c, d with a x + b y
 * + c z + d = 0, in metres.
 * \param[in] patch in the frame of the cloud
 * \param[out] coefficients the header is not changed \ingroup segmentation */
ACMAP_EXPORT void
toModelCoefficients(const PlanePatch& patch, ModelCoefficients& coefficients);

namespace acmap {

/** \brief Covariance of points that are distributed uniformly over the polygons of a
 * patch and deviate from its plane as its support does; square metres. It is not the
 * covariance of PlanePatch, which is the uncertainty of the plane's parameters.
 * \ingroup segmentation */
ACMAP_EXPORT Eigen::Matrix3d
spreadOf(const PlanePatch& patch);

/** \brief Returns the point indices of each plane, given the plane of each point (-1
 * for none). */
ACMAP_EXPORT std::vector<PointIndices>
clustersOf(const PointLabels& labels, std::size_t planes, const PCLHeader& header);

/** \brief Returns the outer boundary of the largest polygon, or an empty one if there
 * is none. */
ACMAP_EXPORT std::vector<Eigen::Vector3f>
largestRim(const PlanePatch& patch);

} // namespace acmap

/** \brief Converts a plane to the type that PCL's organized segmentation returns.
 *
 * The contour is the outer boundary of the largest polygon, the count is the support,
 * and the centroid is the centre of the patch. PCL's covariance is that of the points:
 * see \ref acmap::spreadOf. Holes, other polygons and the uncertainty of the plane are
 * lost.
 * \param[in] patch in the frame of the cloud, metres
 * \param[out] region the fields of its contour points other than x, y, z have their
 * default values \ingroup segmentation */
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
  constexpr std::size_t maximum = std::numeric_limits<unsigned>::max();
  region = PlanarRegion<PointT>(patch.center.cast<float>(),
                                spread.cast<float>(),
                                static_cast<unsigned>(std::min(patch.support, maximum)),
                                contour,
                                patch.coefficients.cast<float>());
  const double thickness = patch.rms * patch.rms;
  region.setCurvature(thickness > 0 ? static_cast<float>(thickness / spread.trace())
                                    : 0.0F);
}

} // namespace pcl
