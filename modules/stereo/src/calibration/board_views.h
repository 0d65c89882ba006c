#pragma once

#include <pcl/core/rig_calibration.h>
#include <pcl/stereo/rig_calibrator_types.h>

#include <opencv2/core.hpp>

#include <functional>
#include <vector>

namespace pcl::acmap {

/** \brief A board as a camera saw it. */
struct BoardView {
  std::size_t image = 0; ///< in the report
  std::size_t shot = 0;
  std::vector<cv::Point2f> corners; ///< px
  Eigen::Isometry3d T_camera_board; ///< set by the fit of the camera
};

/** \brief Told of each view that is left out. */
using LeaveOut = std::function<void(const BoardView& view, const std::string& reason)>;

/** \brief The corners on the board, metres, in the order of the views. */
std::vector<cv::Point3f>
boardPoints(const CalibrationBoard& board);

/** \brief Worst error that is no outlier: three times the median, but not below what a
 * good corner has. \param[in] floor px */
double
outlierLimit(std::vector<double> errors, double floor);

/** \brief Fits pinhole and distortion (k1, k2, p1, p2) to the views, leaving out outliers
 * one after the other; the views that remain get their poses.
 * \param[out] errors px, RMS of each view that remains
 * \throws InitFailedException with too few */
CameraCalibration
fitCamera(const CalibrationBoard& board,
          const cv::Size& size,
          const std::string& name,
          std::vector<BoardView>& views,
          std::vector<double>& errors,
          const LeaveOut& leave_out);

/** \brief Fits the place of a neighbour to the shots that both cameras saw.
 * \param[in,out] views of the neighbour; those that do not fit are left out
 * \throws InitFailedException with too few */
void
fitPlace(const CalibrationBoard& board,
         const cv::Size& size,
         const std::string& name,
         const CameraCalibration& reference,
         const std::vector<BoardView>& reference_views,
         CameraCalibration& neighbour,
         std::vector<BoardView>& views,
         const LeaveOut& leave_out);

} // namespace pcl::acmap
