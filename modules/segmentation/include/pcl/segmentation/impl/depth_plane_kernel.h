#pragma once

#include <pcl/core/impl/depth_planes.h>
#include <pcl/segmentation/depth_plane_types.h>
#include <pcl/segmentation/impl/plane_clustering_kernel.h>

namespace pcl::acmap {

/** \brief Settings of \ref segmentDepthPlanes; see DepthPlaneSegmentation. */
struct DepthSegmentationSettings {
  double min_area = 0;  ///< square metres; 0 is automatic
  bool regular = false; ///< rotate planes to be parallel or perpendicular
};

/** \brief The kernel of DepthPlaneSegmentation, independent of PCL's point types.
 * \param[in] noise of the view
 * \param[out] report counts, seconds, remarks; it is reset first
 * \return patches; labels: for each pixel the number of its patch
 * \throws CancelledException when the progress callback requested to stop
 * \ingroup segmentation */
ACMAP_EXPORT PlaneClusters
segmentDepthPlanes(const DepthView& view,
                   const NoiseScale::InverseDepth& noise,
                   const DepthSegmentationSettings& settings,
                   const Progress& progress,
                   DepthPlaneReport& report);

} // namespace pcl::acmap
