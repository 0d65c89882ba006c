#pragma once

#include <pcl/core/report.h>
#include <pcl/core/trinocular_frame.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl {

/** \brief A printed chessboard. One of the two counts must be even and the other odd;
 * otherwise the board looks the same upside down. \ingroup stereo */
struct CalibrationBoard {
  int columns = 9;      ///< inner corners along a row
  int rows = 6;         ///< inner corners along a column
  double square = 0.03; ///< metres, side of a square
};

/** \brief Result for one board image. \ingroup stereo */
struct BoardImage {
  std::string name;
  RigCamera camera = RigCamera::Reference;
  std::size_t shot = 0;      ///< from 0
  std::string reason;        ///< why it was excluded; empty if it was used
  double reprojection = 0.0; ///< px, RMS over its corners, from the fit of its camera
};

/** \brief Report of \ref RigCalibrator. \ingroup stereo */
struct RigCalibratorReport : Report {
  std::vector<BoardImage> images; ///< by shot, then by camera

  std::array<std::size_t, 3> boards{0, 0, 0};  ///< number used, by \ref RigCamera
  std::array<double, 3> reprojection{0, 0, 0}; ///< px, RMS, by \ref RigCamera

  /** \brief RMS over all corners, px: difference of the rows of a corner in the
   * rectified horizontal pair, and of its columns in the vertical pair. 0 without the
   * camera. */
  double row_residual = 0;
  double column_residual = 0;

  /** \brief Share of the cells of the reference image (a grid of 8 x 6) that contain
   * corners. */
  double coverage = 0;
};

} // namespace pcl
