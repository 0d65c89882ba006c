#pragma once

#include <pcl/core/export.h>
#include <pcl/core/point_types.h>
#include <pcl/core/report.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/point_cloud.h>
#include <pcl/stereo/matched_disparity.h>

#include <array>
#include <cstddef>
#include <optional>

namespace pcl {

/** \brief What \ref DisparityBackProjection tells about its last run. \ingroup stereo */
struct DisparityBackProjectionReport : Report {
  std::size_t points = 0;   ///< with a place
  std::size_t invalid = 0;  ///< pixels without a disparity
  std::size_t too_near = 0; ///< nearer than the least depth
  std::size_t too_far = 0;  ///< farther than the largest depth, or disparity 0 or below
};

/** \brief Turns disparities into an organized cloud in the frame of the reference camera
 * (x right, y down, z forward, metres): Z = f B / d, X = (column - center_x) Z / f,
 * Y = (row - center_y) Z / f. Section II-A of "Active Stereo Based Compact Mapping".
 *
 * `sigma` is one standard deviation along the ray, metres: the disparity's times Z^2 / (f
 * B), times the length of the ray at Z = 1. `rgb` is valid at every pixel, also where
 * there is no place (NaN).
 *
 * pcl::DisparityMapConverter does less and takes other input: a file or buffer of
 * disparities without standard deviations, of which it makes points without `sigma`; its
 * verb returns silently where images are missing. It is no base of this class. Time O(n)
 * for n pixels.
 * \code
 * pcl::DisparityBackProjection projection;
 * projection.setInputRig (grabber.getRig ());
 * pcl::PointCloud<pcl::PointXYZRGBSigma> cloud;
 * projection.project (fused, fusion.getColor (), cloud);
 * \endcode
 * \ingroup stereo */
class ACMAP_EXPORT DisparityBackProjection {
public:
  /** \throws BadArgumentException as \ref TrinocularMatching::setInputRig */
  void
  setInputRig(const TrinocularRig& rig);

  /** \throws InitFailedException without a rig */
  const TrinocularRig&
  getInputRig() const;

  /** \brief Nearer points have no place, metres (default 0: none).
   * \throws BadArgumentException unless within [0, 10000] */
  void
  setMinimumDepth(double depth);

  double
  getMinimumDepth() const
  {
    return minimum_depth_;
  }

  /** \brief Farther points have no place, metres (default 100).
   * \throws BadArgumentException unless within [0.01, 10000] */
  void
  setMaximumDepth(double depth);

  double
  getMaximumDepth() const
  {
    return maximum_depth_;
  }

  /** \param[in] threads 0 for all; the result does not depend on it */
  void
  setNumberOfThreads(unsigned threads)
  {
    threads_ = threads;
  }

  unsigned
  getNumberOfThreads() const
  {
    return threads_;
  }

  /** \param[in] matched of the rig's size, disparity and sigma only; where it has no
   * finite sigma of at least 0, or none at all, the rig's is taken
   * \param[in] color of the rig's size, 1 or 3 channels; empty: black
   * \param[out] cloud organized, as large as the rig's view; untouched after an exception
   * \throws InitFailedException without a rig
   * \throws BadArgumentException for another size or missing values, and where the least
   * depth is not below the largest */
  void
  project(const MatchedDisparity& matched,
          const CameraImage& color,
          PointCloud<PointXYZRGBSigma>& cloud);

  DisparityBackProjectionReport
  getReport() const
  {
    return report_;
  }

private:
  std::optional<TrinocularRig> rig_;
  double minimum_depth_ = 0.0;
  double maximum_depth_ = 100.0;
  unsigned threads_ = 0;
  DisparityBackProjectionReport report_;
};

} // namespace pcl
