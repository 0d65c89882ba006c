#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/report.h>
#include <pcl/core/rig_calibration.h>

#include <array>
#include <memory>

namespace pcl {

/** \brief Report of \ref TrinocularRectification on its calibration.
 * \ingroup stereo */
struct TrinocularRectificationReport : Report {
  /** \brief Rotation angle of each camera, degrees, by \ref RigCamera. */
  std::array<double, 3> turns{0, 0, 0};

  /** \brief Offset of the vertical neighbour from the reference along x after
   * rectification, metres. */
  double column_offset = 0;

  /** \brief Distance of a point at the nearest depth from its column that results from
   * this offset, px. No rotation can remove it, see
   * doc/stereo/trinocular_rectification.md. */
  double column_residual = 0;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const TrinocularRectificationReport& report, Visitor&& visit)
{
  visit({"turns", "deg"}, acmap::Named{report.turns, acmap::rig_camera_names});
  visit({"column_offset", "m"}, report.column_offset);
  visit({"column_residual", "px"}, report.column_residual);
}

/** \brief Rectifies the frames of a physical rig: the distortion is removed, the rows
 * of the horizontal pair and the columns of the vertical pair are aligned, and all
 * cameras have the same focal length and principal point. Section II-A of "Active
 * Stereo Based Compact Mapping" assumes this geometry.
 *
 * The common frame has x along the horizontal baseline and z perpendicular to both
 * baselines. The focal length is the smallest one for which no image has an empty
 * border; width and height are unchanged. Tables are computed once per calibration; a
 * frame then takes O(pixels), one bilinear interpolation per pixel.
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

  /** \brief The calibration of the physical rig: the reference and at least one
   * neighbour. If it is rejected, the previous one is kept.
   * \throws BadArgumentException when there is no neighbour, a value is not finite, a
   * neighbour is not in the direction of its name to within 60 degrees, the baselines
   * are less than 60 degrees apart, the cameras do not look across their baselines, the
   * views have no common part, or the distortion has no inverse */
  void
  setInputCalibration(const RigCalibration& calibration);

  /** \brief Depth for which the column residual is reported, metres (default 1). A
   * residual of more than half a pixel causes a remark.
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

  /** \brief The rig of the rectified frames.
   * \throws InitFailedException without a calibration */
  const TrinocularRig&
  getRig() const;

  /** \brief Rotates directions from the frame of a raw camera to the common frame. The
   * centres of the cameras are unchanged: if the pose of the raw reference camera is
   * T_map_reference, the pose of the rectified view is T_map_reference times the
   * inverse of this rotation.
   * \throws InitFailedException without a calibration
   * \throws BadArgumentException without such a camera */
  Eigen::Matrix3d
  getRotation(RigCamera camera) const;

  /** \throws InitFailedException without a calibration */
  TrinocularRectificationReport
  getReport() const;

  /** \brief Position of a pixel of a raw image in the rectified image, px; NaN if the
   * pixel has no ray.
   * \throws InitFailedException without a calibration
   * \throws BadArgumentException without such a camera */
  Eigen::Vector2d
  rectifiedPixel(RigCamera camera, const Eigen::Vector2d& pixel) const;

  /** \brief Rectifies the images of a frame, grey or in colour. Empty images remain
   * empty; number, observation, pattern and stamp are copied.
   * \param[out] rectified may be the frame itself; unchanged after an exception
   * \throws InitFailedException without a calibration
   * \throws BadArgumentException when an image is incomplete, not of the size of the
   * calibration, or of a camera that the calibration does not have */
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
