#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/point_types.h>
#include <pcl/core/report.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/point_cloud.h>
#include <pcl/stereo/matched_disparity.h>

#include <array>
#include <cstddef>
#include <optional>

namespace pcl {

/** \brief Report of \ref DisparityBackProjection on its last run. \ingroup stereo */
struct DisparityBackProjectionReport : Report {
  std::size_t points = 0;   ///< with finite coordinates
  std::size_t invalid = 0;  ///< pixels without a disparity
  std::size_t too_near = 0; ///< nearer than the minimum depth
  std::size_t too_far = 0;  ///< beyond the maximum depth, or disparity 0 or below
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const DisparityBackProjectionReport& report, Visitor&& visit)
{
  visit({"points"}, report.points);
  visit({"invalid"}, report.invalid);
  visit({"too_near"}, report.too_near);
  visit({"too_far"}, report.too_far);
}

/** \brief Turns disparities into an organized cloud in the frame of the reference
 * camera (x right, y down, z forward, metres): Z = f B / d,
 * X = (column - center_x) Z / f, Y = (row - center_y) Z / f. Section II-A of "Active
 * Stereo Based Compact Mapping".
 *
 * `sigma` is one standard deviation along the ray, in metres: the standard deviation of
 * the disparity times Z^2 / (f B), times the length of the ray at Z = 1. `rgb` is valid
 * at every pixel, even if the coordinates are NaN.
 *
 * pcl::DisparityMapConverter is not a base of this class, because its input is
 * different: a file or a buffer of disparities without standard deviations, from which
 * it computes points without `sigma`; it returns silently if images are missing. Time
 * O(n) for n pixels.
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

  /** \brief Points that are nearer are set to NaN, metres (default 0: none).
   * \throws BadArgumentException unless within [0, 10000] */
  void
  setMinimumDepth(double depth);

  double
  getMinimumDepth() const
  {
    return minimum_depth_;
  }

  /** \brief Points that are farther are set to NaN, metres (default 100).
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
    threads_ = acmap::requiredThreads(threads);
  }

  unsigned
  getNumberOfThreads() const
  {
    return threads_;
  }

  /** \param[in] matched of the size of the rig; only disparity and sigma are read. If
   * sigma is missing, not finite or negative, the disparity_sigma of the rig is used
   * \param[in] color of the size of the rig, 1 or 3 channels; if empty, points are
   * black
   * \param[out] cloud organized, of the size of the rig; unchanged after an exception
   * \throws InitFailedException without a rig
   * \throws BadArgumentException for another size or an incomplete image, and if the
   * minimum depth is not below the maximum */
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
