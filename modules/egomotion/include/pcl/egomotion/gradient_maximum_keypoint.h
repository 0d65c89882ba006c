#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/point_types.h>
#include <pcl/core/report.h>
#include <pcl/egomotion/impl/keypoint_kernel.h>
#include <pcl/keypoints/keypoint.h>
#include <pcl/memory.h>

#include <cstddef>

namespace pcl {

/** \brief Report of GradientMaximumKeypoint on its last run. \ingroup egomotion */
struct GradientMaximumReport : Report {
  std::size_t keypoints = 0;
  std::size_t maxima = 0;        ///< strict maxima of at least the minimum gradient
  std::size_t without_place = 0; ///< maxima without a point, or not among the indices
  std::size_t left_out = 0;      ///< maxima with a point beyond the maximum number
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const GradientMaximumReport& report, Visitor&& visit)
{
  visit({"keypoints"}, report.keypoints);
  visit({"maxima"}, report.maxima);
  visit({"without_place"}, report.without_place);
  visit({"left_out"}, report.left_out);
}

/** \brief Keypoints that can be recognised again: strict local maxima of the gradient
 * of the reference image that have a 3D point. Feature extraction of "Active Stereo
 * Based Compact Mapping", II-B.1: the constrained cloud C~_t.
 *
 * The image is the colour of an organized cloud. Use clouds with the colour of a shot
 * without a pattern, such as those of \ref ActiveStereoGrabber and `pcl_active_stereo`:
 * projected lines move with the robot and would be misleading. Brightness is
 * .299 r + .587 g + .114 b, smoothed with a Gaussian of one pixel. If there are more
 * maxima than \ref setMaximumKeypoints, those with less than half the gradient of the
 * last one that would be selected by strength alone are excluded; the others are
 * selected in turns from cells of 32 x 24 pixels, the strongest of each cell first, so
 * that they are spread over the image.
 *
 * Output: the points themselves, metres, ordered by their indices (getKeypointsIndices
 * of PCL). Neither a search tree nor a radius is required. If indices are set, only
 * these can be keypoints. Time O(n) for n pixels; the result is the same for every
 * number of threads.
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

  /** \brief Sets the minimum gradient (default 0.5), grey levels (of 255) per pixel.
   * Noise causes gradients of a quarter to a half of its standard deviation; they are
   * excluded wherever there is stronger texture.
   * \throws BadArgumentException unless within [0, 1000] */
  void
  setMinimumGradient(float gradient);

  float
  getMinimumGradient() const
  {
    return settings_.min_gradient;
  }

  /** \brief Sets the maximum number of keypoints (default 1000).
   * \throws BadArgumentException unless within [1, 1e6] */
  void
  setMaximumKeypoints(std::size_t keypoints);

  std::size_t
  getMaximumKeypoints() const
  {
    return settings_.maximum;
  }

  /** \brief Sets the number of threads (0 = all, default); the result is the same. */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    settings_.threads = acmap::requiredThreads(threads);
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

// PCL provides no search trees for this point type, but Keypoint refers to them.
extern template class ACMAP_EXPORT Keypoint<PointXYZRGBSigma, PointXYZRGBSigma>;

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/egomotion/impl/gradient_maximum_keypoint.hpp>
#endif
