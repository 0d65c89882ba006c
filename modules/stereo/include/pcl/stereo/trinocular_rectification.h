#pragma once

#include <pcl/core/export.h>
#include <pcl/core/report.h>
#include <pcl/core/rig_calibration.h>

#include <array>
#include <memory>

namespace pcl {

/** \brief What \ref TrinocularRectification tells about its calibration.
 * \ingroup stereo */
struct TrinocularRectificationReport : Report {
  /** \brief Degrees by which each camera is turned, by \ref RigCamera. */
  std::array<double, 3> turns{0, 0, 0};

  /** \brief Metres by which the vertical neighbour stands beside the reference's column
   * (along x), after rectification. */
  double column_offset = 0;

  /** \brief What it costs: px by which a point at the nearest depth lies beside its
   * column. No rotation can take it off, see doc/stereo/trinocular_rectification.md. */
  double column_residual = 0;
};

/** \brief Turns the frames of a rig as it is built into those of a rectified one: the
 * distortion is off, the rows of the horizontal pair and the columns of the vertical pair
 * are aligned, all cameras have one focal length and one principal point (the geometry
 * that section II-A of "Active Stereo Based Compact Mapping" takes for granted).
 *
 * The common frame has x along the horizontal baseline and z perpendicular to both
 * baselines. The focal length is the shortest that leaves no border without image in any
 * camera; width and height stay. Tables are made once, with the calibration; a frame then
 * takes O(pixels), an interpolation each.
 * \code
 * pcl::TrinocularRectification rectification;
 * rectification.setInputCalibration (pcl::loadRigCalibration ("rig.yaml"));
 * pcl::TrinocularFrame rectified;
 * rectification.rectify (frame, rectified);
 * \endcode
 * \ingroup stereo */
class ACMAP_EXPORT TrinocularRectification {
public:
  TrinocularRectification();
  ~TrinocularRectification();
  TrinocularRectification(TrinocularRectification&&) noexcept;
  TrinocularRectification&
  operator=(TrinocularRectification&&) noexcept;

  /** \brief The cameras as they are built: the reference and at least one neighbour. What
   * was set before stays when they are refused.
   * \throws BadArgumentException when they are no such rig: no neighbour, a value that is
   * not finite, baselines less than 60 degrees apart, cameras that do not look across
   * their baselines, views without a common part, a distortion without an inverse */
  void
  setInputCalibration(const RigCalibration& calibration);

  /** \brief Depth for which the column residual is told, metres, 1 without. A residual of
   * more than half a pixel gives a remark.
   * \throws BadArgumentException when not within [0.01, 1000] */
  void
  setNearestDepth(double depth);

  double
  getNearestDepth() const
  {
    return nearest_depth_;
  }

  /** \param[in] threads 0 for all; the result does not depend on it */
  void
  setNumberOfThreads(unsigned threads);

  unsigned
  getNumberOfThreads() const
  {
    return threads_;
  }

  /** \brief The rig that the rectified frames are of.
   * \throws InitFailedException without a calibration */
  const TrinocularRig&
  getRig() const;

  /** \brief Turns directions of a raw camera's frame into the common frame. The centres of
   * the cameras stay: a raw reference camera at T_map_reference gives rectified views from
   * T_map_reference times the inverse of its rotation.
   * \throws InitFailedException without a calibration
   * \throws BadArgumentException without such a camera */
  Eigen::Matrix3d
  getRotation(RigCamera camera) const;

  /** \throws InitFailedException without a calibration */
  TrinocularRectificationReport
  getReport() const;

  /** \brief Where a pixel of a raw image comes to lie, px; NaN where it has no ray.
   * \throws InitFailedException without a calibration
   * \throws BadArgumentException without such a camera */
  Eigen::Vector2d
  rectifiedPixel(RigCamera camera, const Eigen::Vector2d& pixel) const;

  /** \brief Rectifies the images of a frame, grey or in colour; those that are empty stay
   * empty, number, observation, pattern and stamp are taken over.
   * \param[out] rectified may be the frame itself; untouched after an exception
   * \throws InitFailedException without a calibration
   * \throws BadArgumentException when an image has another size than the calibration, not
   * all its values, or no camera in the calibration */
  void
  rectify(const TrinocularFrame& frame, TrinocularFrame& rectified) const;

private:
  struct State;

  const State&
  requireState() const;

  const CameraCalibration&
  requireCamera(RigCamera camera) const;

  std::unique_ptr<const State> state_;
  double nearest_depth_ = 1.0;
  unsigned threads_ = 0;
};

} // namespace pcl
