#pragma once

#include <pcl/core/fields.h>
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

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const BoardImage& image, Visitor&& visit)
{
  visit({"name"}, image.name);
  visit({"camera"}, acmap::Named{image.camera, acmap::rig_camera_names});
  visit({"shot"}, image.shot);
  visit({"left_out"}, image.reason);
  visit({"reprojection", "px"}, image.reprojection);
}

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

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const RigCalibratorReport& report, Visitor&& visit)
{
  visit({"images"}, report.images);
  visit({"boards"}, acmap::Named{report.boards, acmap::rig_camera_names});
  visit({"reprojection", "px"},
        acmap::Named{report.reprojection, acmap::rig_camera_names});
  visit({"row_residual", "px"}, report.row_residual);
  visit({"column_residual", "px"}, report.column_residual);
  visit({"coverage"}, report.coverage);
}

} // namespace pcl
