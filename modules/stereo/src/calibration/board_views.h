#pragma once

#include <pcl/core/rig_calibration.h>
#include <pcl/stereo/rig_calibrator_types.h>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <functional>
#include <vector>

namespace pcl::acmap {

/** \brief A board as seen by a camera. */
struct BoardView {
  std::size_t image = 0; ///< index in the report
  std::size_t shot = 0;
  std::vector<cv::Point2f> corners; ///< px
  Eigen::Isometry3d T_camera_board; ///< set by the calibration of the camera
};

/** \brief Is called for each view that is excluded. */
using LeaveOut = std::function<void(const BoardView& view, const std::string& reason)>;

/** \brief The corners on the board, metres, in the order of the views. */
std::vector<cv::Point3f>
boardPoints(const CalibrationBoard& board);

/** \brief Maximum error of an inlier: three times the median, but at least \a floor.
 * \param[in] errors, floor px */
double
outlierLimit(std::vector<double> errors, double floor);

/** \brief Fits pinhole and distortion (k1, k2, p1, p2) to the views and excludes
 * outliers one after the other; sets the poses of the remaining views.
 * \param[out] errors px, RMS of each remaining view
 * \throws InitFailedException if too few views remain */
CameraCalibration
fitCamera(const CalibrationBoard& board,
          const cv::Size& size,
          const std::string& name,
          std::vector<BoardView>& views,
          std::vector<double>& errors,
          const LeaveOut& leave_out);

/** \brief Fits the pose of a neighbour to the shots that both cameras saw.
 * \param[in,out] views of the neighbour; those that do not fit are removed
 * \throws InitFailedException if too few shots remain */
void
fitPlace(const CalibrationBoard& board,
         const cv::Size& size,
         const std::string& name,
         const CameraCalibration& reference,
         const std::vector<BoardView>& reference_views,
         CameraCalibration& neighbour,
         std::vector<BoardView>& views,
         const LeaveOut& leave_out);

/** \brief The corners of a board in an image, or the reason why there are none. */
struct BoardCorners {
  std::vector<Eigen::Vector2f> corners; ///< rows * columns, row by row, px
  std::string reason;                   ///< empty if the board is good
};

/** \brief Finds the board. The first corner is the same physical corner in each image:
 * the order is clockwise on the board and starts at a dark square. */
BoardCorners
findBoard(const CameraImage& image, const CalibrationBoard& board);

} // namespace pcl::acmap
