#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/core/stage_controls.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/depth_plane_types.h>
#include <pcl/segmentation/impl/depth_plane_kernel.h>

#include <cstdint>
#include <vector>

namespace pcl {

/** \brief Finds all planes of one view of a depth camera in its depth image.
 *
 * Structured light and stereo cameras measure disparities. Their noise and quantisation
 * steps are uniform in inverse depth; in metres they grow with the square of the
 * distance. In 3D space, the far wall of a Kinect's view is a stack of layers; in the
 * image of 1/z it is a plane with the same noise as any other. Therefore the planes are
 * grown there (acmap::findDepthPlanes), each pixel is assigned to the plane that
 * it fits, and each plane gets its equation, covariance and outline.
 * The noise is measured on the view itself (NoiseScale::InverseDepth): the quantisation
 * steps of the sensor, the independent error of each pixel, and the error that
 * neighbours share.
 *
 * The input is an organized cloud in the frame of its sensor (x right, y down, z
 * forward, metres), as grabbers and files of RGB-D cameras provide it; pixels without a
 * measurement are NaN. If such pixels were removed (removeNaNFromPointCloud), the image
 * is restored from the points (acmap::findPictureOrder).
 * Normals point towards the sensor. The result is the same in every run and for any
 * number of threads. The time is linear, some ten milliseconds for 640 x 480 pixels.
 * \code
 * pcl::DepthPlaneSegmentation<pcl::PointXYZRGB> segmentation;
 * segmentation.setInputCloud (kinect_view);
 * std::vector<pcl::PlanePatch> planes;
 * segmentation.segment (planes);
 * \endcode
 * This class is not part of "Active Stereo Based Compact Mapping", whose section II-C.2
 * clusters hypotheses in 3D space. For merged clouds use PlaneHypothesisClustering.
 * \ingroup segmentation
 */
template <typename PointT>
class DepthPlaneSegmentation : public PCLBase<PointT>,
                               public StageControls<DepthPlaneReport> {
public:
  using Ptr = shared_ptr<DepthPlaneSegmentation<PointT>>;
  using ConstPtr = shared_ptr<const DepthPlaneSegmentation<PointT>>;
  using PointCloudConstPtr = typename PCLBase<PointT>::PointCloudConstPtr;

  /** \brief Sets the minimum area of a plane.
   * \param[in] area square metres; 0 (default) is automatic: 0.1, or 0.3 % of the
   * visible surface if that is smaller
   * \throws BadArgumentException when it is negative or not finite */
  void
  setMinArea(double area);

  double
  getMinArea() const
  {
    return settings_.min_area;
  }

  /** \brief Rotates planes about their centres to be exactly parallel or perpendicular
   * to larger ones (default false), by at most three standard deviations of their tilt
   * and at most one degree. */
  void
  setRegularize(bool regularize)
  {
    settings_.regular = regularize;
  }

  bool
  getRegularize() const
  {
    return settings_.regular;
  }

  /** \brief All settings. */
  const acmap::DepthSegmentationSettings&
  settings() const
  {
    return settings_;
  }

  /** \brief Finds all planes of the view, or of its indices if they are set; the other
   * pixels then count as not measured.
   * \param[out] patches in order of decreasing area; empty if there are no planes, or
   * if no pinhole camera fits the points, because they are not in the frame of their
   * sensor. The report contains the reason.
   * \throws InitFailedException without a cloud, or with indices outside of it
   * \throws UnorganizedPointCloudException when the cloud is not organized and its
   * image cannot be restored
   * \throws CancelledException when the progress callback requested to stop */
  void
  segment(std::vector<PlanePatch>& patches);

  /** \brief Same as segment, but returns the point indices of each plane, like the
   * inliers of OrganizedMultiPlaneSegmentation. */
  void
  extract(std::vector<PointIndices>& clusters);

  /** \brief For each point of the input cloud the number of its plane in the last
   * result, -1 for none. */
  const PointLabels&
  getLabels() const
  {
    return labels_;
  }

protected:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

private:
  acmap::DepthSegmentationSettings settings_;
  PointLabels labels_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/depth_plane_segmentation.hpp>
#endif
