#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/export.h>
#include <pcl/core/point_types.h>
#include <pcl/core/report.h>
#include <pcl/egomotion/keypoint_kernel.h>
#include <pcl/keypoints/keypoint.h>
#include <pcl/memory.h>

#include <cstddef>

namespace pcl {

/** \brief What GradientMaximumKeypoint tells about its last run. \ingroup egomotion */
struct GradientMaximumReport : Report {
  std::size_t keypoints = 0;
  std::size_t maxima = 0;        ///< strict, of at least the least gradient
  std::size_t without_place = 0; ///< of these: no 3D there, or not among the indices
  std::size_t left_out = 0;      ///< with a place, beyond the number asked for
};

/** \brief Points to recognise again: strict local maxima of the reference image's
 * gradient that have a place in 3D. Feature extraction of "Active Stereo Based Compact
 * Mapping", II-B.1: the constrained cloud C~_t.
 *
 * The image is the colour of an organized cloud; take clouds whose colour is that of a
 * shot without a pattern, as \ref ActiveStereoGrabber and `pcl_active_stereo` make
 * them: projected lines move with the robot and would mislead. Brightness is
 * .299 r + .587 g + .114 b, smoothed with a Gaussian of one pixel. Where there are
 * more than \ref setMaximumKeypoints, those of less than half the gradient at which
 * strength alone would end are left out, and of the others cells of 32 x 24 pixels give
 * their strongest in turn, so that they spread over the image.
 *
 * Output: the points themselves, metres, in the order of their indices (PCL's
 * getKeypointsIndices). No search tree, no radius. Where indices are set, only these can
 * be keypoints. Time O(n) for n pixels; the same bytes for every number of threads.
 * \code
 * pcl::GradientMaximumKeypoint<pcl::PointXYZRGB> detector;
 * detector.setInputCloud (cloud);
 * pcl::PointCloud<pcl::PointXYZRGB> keypoints;
 * detector.compute (keypoints);
 * \endcode
 * \ingroup egomotion
 */
template <typename PointT>
class GradientMaximumKeypoint : public Keypoint<PointT, PointT> {
public:
  using Ptr = shared_ptr<GradientMaximumKeypoint<PointT>>;
  using ConstPtr = shared_ptr<const GradientMaximumKeypoint<PointT>>;
  using PointCloudOut = typename Keypoint<PointT, PointT>::PointCloudOut;

  GradientMaximumKeypoint();

  /** \brief Sets the least gradient (default 0.5), grey levels (of 255) a pixel. What
   * grain makes is a quarter to a half of its standard deviation; it is beaten where
   * anything else is to be seen.
   * \throws BadArgumentException unless within [0, 1000] */
  void
  setMinimumGradient(float gradient);

  float
  getMinimumGradient() const
  {
    return settings_.least_gradient;
  }

  /** \brief Sets how many at most (default 1000).
   * \throws BadArgumentException unless within [1, 1e6] */
  void
  setMaximumKeypoints(std::size_t keypoints);

  std::size_t
  getMaximumKeypoints() const
  {
    return settings_.most;
  }

  /** \brief Sets the number of threads (0 = all, default); the result is the same. */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    settings_.threads = threads;
  }

  unsigned
  getNumberOfThreads() const
  {
    return settings_.threads;
  }

  const GradientMaximumReport&
  getReport() const
  {
    return report_;
  }

  /** \brief Finds the keypoints.
   * \throws InitFailedException without an input cloud, or for an index outside of it
   * \throws UnorganizedPointCloudException unless the cloud is organized (or empty) */
  void
  compute(PointCloudOut& output);

protected:
  bool
  initCompute() override;

  void
  detectKeypoints(PointCloudOut& output) override;

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;
  using Keypoint<PointT, PointT>::keypoints_indices_;

  acmap::KeypointSettings settings_;
  GradientMaximumReport report_;
};

// PCL has no search trees compiled for our point type, and Keypoint names them
extern template class ACMAP_EXPORT Keypoint<PointXYZRGBSigma, PointXYZRGBSigma>;

} // namespace pcl
