#pragma once

#include <pcl/core/depth_planes.h>
#include <pcl/segmentation/depth_plane_types.h>
#include <pcl/segmentation/plane_clustering_kernel.h>

namespace pcl::acmap {

/** \brief Settings of \ref segmentDepthPlanes; see DepthPlaneSegmentation. */
struct DepthSegmentationSettings {
  double least_area = 0; ///< square metres; 0 is automatic
  bool regular = false;  ///< turn planes to right angles
};

/** \brief The kernel behind DepthPlaneSegmentation, free of PCL's point types.
 * \param[in] noise of the view
 * \param[out] report counts, seconds, remarks; begun anew
 * \return patches, and for each pixel its patch as labels
 * \throws CancelledException when the progress was told to stop \ingroup segmentation */
ACMAP_EXPORT PlaneClusters
segmentDepthPlanes(const DepthView& view,
                   const NoiseScale::InverseDepth& noise,
                   const DepthSegmentationSettings& settings,
                   const Progress& progress,
                   DepthPlaneReport& report);

} // namespace pcl::acmap
