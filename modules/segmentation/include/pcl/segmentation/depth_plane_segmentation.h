#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/stage_controls.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/depth_plane_types.h>

#include <cstdint>
#include <vector>

namespace pcl {

/** \brief All planes of one view of a depth camera, found in its picture.
 *
 * Structured light and stereo measure disparities: their noise and their steps are even in
 * inverse depth, and grow with the square of the distance in metres. In space the far wall
 * of a Kinect's view is a stack of layers; in its picture it is a plane of 1/z with the
 * noise of any other. So planes are grown there (\ref acmap::findDepthPlanes), each pixel
 * goes to the plane it fits, and each plane gets its equation, covariance and outline.
 * The noise is measured on the view itself (NoiseScale::InverseDepth): the sensor's steps,
 * what each pixel errs on its own and what neighbours share.
 *
 * Takes an organized cloud in its sensor's frame (x right, y down, z forward, metres), as
 * grabbers and files of RGB-D cameras have it; pixels without a measurement are NaN. A view
 * from which such pixels were removed (removeNaNFromPointCloud) is put back into its
 * picture (\ref acmap::findPictureOrder).
 * Normals look towards the sensor. The same answer at every run and for every number of
 * threads; linear time, some ten milliseconds for 640 x 480 pixels.
 * \code
 * pcl::DepthPlaneSegmentation<pcl::PointXYZRGB> segmentation;
 * segmentation.setInputCloud (kinect_view);
 * std::vector<pcl::PlanePatch> planes;
 * segmentation.segment (planes);
 * \endcode
 * It goes beyond "Active Stereo Based Compact Mapping", whose II-C.2 clusters hypotheses
 * in space; for merged clouds take PlaneHypothesisClustering.
 * \ingroup segmentation
 */
template <typename PointT>
class DepthPlaneSegmentation : public PCLBase<PointT>,
                               public StageControls<DepthPlaneReport> {
public:
  using Ptr = shared_ptr<DepthPlaneSegmentation<PointT>>;
  using ConstPtr = shared_ptr<const DepthPlaneSegmentation<PointT>>;
  using PointCloudConstPtr = typename PCLBase<PointT>::PointCloudConstPtr;

  /** \brief Sets the least area of a plane.
   * \param[in] area square metres; 0 (default): automatic, 0.1, or 0.3 % of all the surface
   * in view where that is less
   * \throws BadArgumentException when negative or not finite */
  void
  setMinArea(double area);

  double
  getMinArea() const
  {
    return least_area_;
  }

  /** \brief Turns planes about their centres to be exactly parallel or at right angles to
   * larger ones (default false), by at most three standard deviations of their tilt and a
   * degree. */
  void
  setRegularize(bool regularize)
  {
    regularize_ = regularize;
  }

  bool
  getRegularize() const
  {
    return regularize_;
  }

  /** \brief Finds all planes of the view (of its indices, where set: the other pixels count
   * as not measured).
   * \param[out] patches by falling area; none, with the reason in the report, where there
   * are none, or no pinhole camera fits the points: they are not in their sensor's frame
   * \throws InitFailedException without a cloud, or with indices outside of it
   * \throws UnorganizedPointCloudException when the cloud is not organized, and cannot be put
   * back into a picture
   * \throws CancelledException when the progress callback stopped it */
  void
  segment(std::vector<PlanePatch>& patches);

  /** \brief The same as the points of each plane, as OrganizedMultiPlaneSegmentation gives
   * its inliers. */
  void
  extract(std::vector<PointIndices>& clusters);

  /** \brief For each point of the input cloud the position of its plane in the last
   * result, -1 for none. */
  const std::vector<std::int32_t>&
  getLabels() const
  {
    return labels_;
  }

protected:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

private:
  double least_area_ = 0;
  bool regularize_ = false;
  std::vector<std::int32_t> labels_;
};

} // namespace pcl
