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
#include <utility>
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

/** \brief Returns the outer boundary of the largest polygon, or an empty one if there
 * is none. */
ACMAP_EXPORT std::vector<Eigen::Vector3f>
largestRim(const PlanePatch& patch);

/** \brief A boundary as a cloud. */
template <typename PointT>
PointCloud<PointT>
boundaryCloud(const std::vector<Eigen::Vector3f>& boundary)
{
  PointCloud<PointT> cloud;
  for (const Eigen::Vector3f& place : boundary) {
    PointT point;
    point.getVector3fMap() = place;
    cloud.push_back(point);
  }
  return cloud;
}

} // namespace acmap

/** \brief Returns the points of each plane, or of each cylinder, in ascending order.
 * \param[in] labels the plane of each point, -1 for none, such as MappedPlanes::labels
 * \param[in] planes their number
 * \param[in] header of all indices
 * \throws BadArgumentException for a label that is not less than that number
 * \ingroup segmentation */
ACMAP_EXPORT std::vector<PointIndices>
toPointIndices(const PointLabels& labels,
               std::size_t planes,
               const PCLHeader& header = {});

/** \brief Copies labels into a vector with the usual allocator. \ingroup segmentation */
inline std::vector<int>
toVector(const PointLabels& labels)
{
  return {labels.begin(), labels.end()};
}

/** \brief A polygon of a plane as clouds. Its outer boundary is counter-clockwise and its
 * holes are clockwise, as seen from the side to which the normal of the plane points.
 * \ingroup segmentation */
template <typename PointT>
struct PlaneOutline {
  PointCloud<PointT> outer;
  std::vector<PointCloud<PointT>> holes;
};

/** \brief Converts all polygons of a plane to clouds, for example for
 * PCLVisualizer::addPolygon and ExtractPolygonalPrismData.
 * \param[in] patch in the frame of the cloud, metres
 * \param[out] outlines one for each polygon; the fields of their points other than x, y, z
 * have their default values \ingroup segmentation */
template <typename PointT>
void
toOutlines(const PlanePatch& patch, std::vector<PlaneOutline<PointT>>& outlines)
{
  outlines.clear();
  for (const PlanePolygon& polygon : patch.polygons) {
    PlaneOutline<PointT> outline{acmap::boundaryCloud<PointT>(polygon.outer), {}};
    for (const std::vector<Eigen::Vector3f>& hole : polygon.holes)
      outline.holes.push_back(acmap::boundaryCloud<PointT>(hole));
    outlines.push_back(std::move(outline));
  }
}

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
  auto contour = acmap::boundaryCloud<PointT>(acmap::largestRim(patch)).points;
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
