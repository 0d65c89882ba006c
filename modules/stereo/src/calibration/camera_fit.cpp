#include "board_views.h"
#include "opencv_values.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/quantile.h>
#include <pcl/stereo/rig_calibrator.h>

#include <opencv2/calib3d.hpp>

#include <algorithm>

namespace pcl::acmap {

std::vector<cv::Point3f>
boardPoints(const CalibrationBoard& board)
{
  std::vector<cv::Point3f> points;
  for (int row = 0; row < board.rows; ++row)
    for (int column = 0; column < board.columns; ++column)
      points.emplace_back(static_cast<float>(column * board.square),
                          static_cast<float>(row * board.square),
                          0.0F);
  return points;
}

double
outlierLimit(std::vector<double> errors, double floor)
{
  return std::max(floor, 3.0 * medianOf(errors));
}

void
requireEnough(const std::string& name, std::size_t views)
{
  if (views < RigCalibrator::min_boards)
    throw acmap::InitFailed("the " + name + " camera has " + std::to_string(views) +
                            " good boards, at least " +
                            std::to_string(RigCalibrator::min_boards) + " are needed");
}

namespace {

/** \brief Result of a fit. */
struct CameraFit {
  cv::Matx33d matrix;
  cv::Mat distortion;
  std::vector<cv::Mat> turns;
  std::vector<cv::Mat> shifts;
  cv::Mat spread; // standard deviations of the parameters, focal lengths first
  std::vector<double> errors;
};

CameraFit
fitOnce(const CalibrationBoard& board,
        const cv::Size& size,
        const std::vector<BoardView>& views)
{
  const std::vector<std::vector<cv::Point3f>> points(views.size(), boardPoints(board));
  std::vector<std::vector<cv::Point2f>> corners;
  for (const BoardView& view : views)
    corners.push_back(view.corners);
  CameraFit fit;
  // A sixth-order term would need more corners near the border than boards provide.
  cv::calibrateCamera(points,
                      corners,
                      size,
                      fit.matrix,
                      fit.distortion,
                      fit.turns,
                      fit.shifts,
                      fit.spread,
                      cv::noArray(),
                      fit.errors,
                      cv::CALIB_FIX_K3);
  return fit;
}

/** \brief Is the focal length determined? Boards of the same orientation fit any. */
bool
isTold(const CameraFit& fit)
{
  constexpr double max_spread = 0.02;
  const double focal = std::min(fit.matrix(0, 0), fit.matrix(1, 1));
  const double spread = std::max(fit.spread.at<double>(0), fit.spread.at<double>(1));
  return focal > 1.0 && spread < max_spread * focal && cv::checkRange(fit.matrix) &&
         cv::checkRange(fit.distortion);
}

CameraFit
fitOrFail(const CalibrationBoard& board,
          const cv::Size& size,
          const std::string& name,
          const std::vector<BoardView>& views)
{
  requireEnough(name, views.size());
  try {
    CameraFit fit = fitOnce(board, size, views);
    if (isTold(fit))
      return fit;
  }
  catch (const cv::Exception& error) {
    requireMemoryWasThere(error);
    // The exception below says what to do.
  }
  throw acmap::InitFailed("the boards do not tell the focal length of the " + name +
                          " camera: hold them at different tilts and distances");
}

} // namespace

CameraCalibration
fitCamera(const CalibrationBoard& board,
          const cv::Size& size,
          const std::string& name,
          std::vector<BoardView>& views,
          std::vector<double>& errors,
          const LeaveOut& leave_out)
{
  constexpr double floor = 0.2; // px
  while (true) {
    CameraFit fit = fitOrFail(board, size, name, views);
    const auto worst = std::max_element(fit.errors.begin(), fit.errors.end());
    if (*worst <= outlierLimit(fit.errors, floor)) {
      for (std::size_t i = 0; i < views.size(); ++i)
        views[i].T_camera_board = poseOf(fit.turns[i], fit.shifts[i]);
      errors = std::move(fit.errors);
      return cameraOf(fit.matrix, fit.distortion);
    }
    const auto at = worst - fit.errors.begin();
    leave_out(views[static_cast<std::size_t>(at)],
              "outlier: " + pixelText(*worst) +
                  " px off the other boards' camera, the median is " +
                  pixelText(outlierLimit(fit.errors, 0.0) / 3.0));
    views.erase(views.begin() + at);
  }
}

} // namespace pcl::acmap
