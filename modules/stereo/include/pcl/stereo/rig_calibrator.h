#pragma once

#include <pcl/core/export.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/stereo/rig_calibrator_types.h>

#include <Eigen/Core>

namespace pcl {

/** \brief Calibrates a trinocular rig from shots of a chessboard: the pinhole
 * parameters and the distortion of each camera, then the pose of each neighbour; the
 * size of the squares defines the scale. Section II-A of "Active Stereo Based Compact
 * Mapping" requires such a rig.
 *
 * A board image is excluded, with name and reason, when no complete board is found in
 * it, when the board is too small or blurred, when the reference did not see that
 * board, when its error exceeds three times the median of its camera's images, or when
 * it does not fit the reference's image of the shot. The others are used. Finding a
 * board takes O(pixels), 40 ms at 640 x 480; a fit takes O(corners) and is repeated for
 * each excluded image.
 * \code
 * pcl::RigCalibrator calibrator;
 * calibrator.setBoard ({9, 6, 0.03});
 * for (const auto& shot : shots)
 *   calibrator.addShot (shot.frame, shot.names);
 * pcl::RigCalibration cameras;
 * pcl::TrinocularRig rig;
 * calibrator.calibrate (cameras, rig);
 * pcl::saveRigCalibration ("rig.yaml", rig, cameras);
 * \endcode
 * \ingroup stereo */
class ACMAP_EXPORT RigCalibrator {
public:
  /** \brief Minimum number of boards per camera. */
  static constexpr std::size_t min_boards = 5;

  /** \brief The board of all shots; discards the shots that were added.
   * \throws BadArgumentException when a count is not within [3, 100], both are even or
   * both odd, or a square not within [1e-4, 10] metres */
  void
  setBoard(const CalibrationBoard& board);

  const CalibrationBoard&
  getBoard() const
  {
    return board_;
  }

  /** \brief Finds the board in the images of a shot; an empty image means that there is
   * no such camera. All images must have the size of the first one.
   * \param[in] names of the images, for the report
   * \throws BadArgumentException when an image is incomplete */
  void
  addShot(const TrinocularFrame& frame, const std::array<std::string, 3>& names);

  /** \brief Computes the calibration from the shots so far.
   * \param[out] calibration the cameras that had images
   * \param[out] rig the rig after rectification
   * \throws InitFailedException when a camera has fewer than \ref min_boards good
   * boards, or no neighbour has images; the report then gives the reason for each
   * excluded image
   * \throws BadArgumentException when the cameras do not form a rig, see
   * \ref TrinocularRectification */
  void
  calibrate(RigCalibration& calibration, TrinocularRig& rig);

  /** \brief Report on the shots so far; complete after \ref calibrate. */
  const RigCalibratorReport&
  getReport() const
  {
    return report_;
  }

  /** \brief Corners found in an image of the report: row by row, px, starting at the
   * corner whose inner square is dark; empty if none were found.
   * \throws BadArgumentException when the report has no such image */
  const std::vector<Eigen::Vector2f>&
  getCorners(std::size_t image) const;

private:
  struct Fit;

  Fit
  beginFit();

  void
  fitCameras(Fit& fit);

  void
  fitPlaces(Fit& fit);

  CalibrationBoard board_;
  int width_ = 0;
  int height_ = 0;
  std::size_t shots_ = 0;
  std::vector<std::vector<Eigen::Vector2f>> corners_; // of report_.images
  std::vector<std::string> detection_; // reasons for exclusion before a fit
  RigCalibratorReport report_;
};

} // namespace pcl
