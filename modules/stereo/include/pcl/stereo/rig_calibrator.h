#pragma once

#include <pcl/core/export.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/stereo/rig_calibrator_types.h>

#include <Eigen/Core>

namespace pcl {

/** \brief Calibrates a trinocular rig from shots of a chessboard: each camera's pinhole
 * and distortion, then the place of each neighbour; lengths in metres by the squares.
 * Section II-A of "Active Stereo Based Compact Mapping" takes such a rig for granted.
 *
 * A board image is left out, by name and reason, when no whole board is found in it, when
 * the board is too small or blurred, when the reference did not see that board, when it
 * fits worse than three times the median of its camera's images, or when it does not fit
 * the reference's image of the shot. The rest is calibrated. Finding a board takes
 * O(pixels), 40 ms at 640 x 480; a fit O(corners), once more for each image left out.
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
  /** \brief Least number of boards that a camera needs. */
  static constexpr std::size_t least_boards = 5;

  /** \brief The board of all shots; takes away those that were added.
   * \throws BadArgumentException when a count is not within [3, 100], both are even or
   * both odd, or a square not within [1e-4, 10] metres */
  void
  setBoard(const CalibrationBoard& board);

  const CalibrationBoard&
  getBoard() const
  {
    return board_;
  }

  /** \brief Looks for the board in the images of a shot; empty images are of cameras that
   * there are not. The first image gives the size of all.
   * \param[in] names of the images, for the report
   * \throws BadArgumentException when an image has not all its values */
  void
  addShot(const TrinocularFrame& frame, const std::array<std::string, 3>& names);

  /** \brief Calibrates from the shots so far.
   * \param[out] calibration the cameras that had images
   * \param[out] rig what they are after rectification
   * \throws InitFailedException when a camera has fewer than \ref least_boards good
   * boards, or no neighbour has images; the report then says why each was left out
   * \throws BadArgumentException when the cameras found are no rig, see
   * \ref TrinocularRectification */
  void
  calibrate(RigCalibration& calibration, TrinocularRig& rig);

  /** \brief Of the shots so far; complete after \ref calibrate. */
  const RigCalibratorReport&
  getReport() const
  {
    return report_;
  }

  /** \brief Corners found in an image of the report: row by row, px, from the corner
   * whose inner square is dark; empty where none were found.
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
  std::vector<std::string> detection_;                // their reasons before a fit
  RigCalibratorReport report_;
};

} // namespace pcl
