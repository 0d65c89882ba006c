#pragma once

#include <pcl/core/report.h>
#include <pcl/core/trinocular_frame.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl {

/** \brief A printed chessboard. One of the two counts is even, the other odd: else the
 * board looks the same upside down. \ingroup stereo */
struct CalibrationBoard {
  int columns = 9;      ///< inner corners along a row
  int rows = 6;         ///< inner corners along a column
  double square = 0.03; ///< metres, side of a square
};

/** \brief What became of a board image. \ingroup stereo */
struct BoardImage {
  std::string name;
  RigCamera camera = RigCamera::Reference;
  std::size_t shot = 0;      ///< from 0
  std::string reason;        ///< why it was left out; empty when it was used
  double reprojection = 0.0; ///< px, RMS over its corners by the camera's own fit
};

/** \brief What \ref RigCalibrator tells. \ingroup stereo */
struct RigCalibratorReport : Report {
  std::vector<BoardImage> images; ///< by shot, then by camera

  std::array<std::size_t, 3> boards{0, 0, 0};  ///< used, by \ref RigCamera
  std::array<double, 3> reprojection{0, 0, 0}; ///< px, RMS, by \ref RigCamera

  /** \brief RMS over all corners, px: rows of a corner in the rectified horizontal pair,
   * columns in the vertical pair. 0 without the camera. */
  double row_residual = 0;
  double column_residual = 0;

  /** \brief Share of the image, in a grid of 8 x 6 cells, in which the reference saw
   * corners. */
  double coverage = 0;
};

} // namespace pcl
