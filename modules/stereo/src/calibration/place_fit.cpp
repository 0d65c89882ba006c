#include "board_views.h"
#include "opencv_values.h"

#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <limits>

namespace pcl::acmap {

namespace {

/** \brief A shot that both cameras saw. */
struct BoardPair {
  const BoardView* reference;
  const BoardView* neighbour;

  Eigen::Isometry3d
  T_reference_neighbour() const
  {
    return reference->T_camera_board * neighbour->T_camera_board.inverse();
  }
};

std::vector<BoardPair>
pairsOf(const std::vector<BoardView>& reference, const std::vector<BoardView>& views)
{
  std::vector<BoardPair> pairs;
  for (const BoardView& view : views)
    for (const BoardView& other : reference)
      if (other.shot == view.shot)
        pairs.push_back({&other, &view});
  return pairs;
}

/** \brief RMS error of the neighbour's corners for the given pose of the neighbour, px.
 */
double
errorOf(const BoardPair& pair,
        const std::vector<cv::Point3f>& points,
        const CameraCalibration& neighbour,
        const Eigen::Isometry3d& T_neighbour_reference)
{
  const Eigen::Isometry3d T_neighbour_board =
      T_neighbour_reference * pair.reference->T_camera_board;
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d point(points[i].x, points[i].y, points[i].z);
    const Eigen::Vector2d seen = projectPoint(neighbour, T_neighbour_board * point);
    const cv::Point2f& corner = pair.neighbour->corners[i];
    sum += (seen - Eigen::Vector2d(corner.x, corner.y)).squaredNorm();
  }
  // A board behind the camera does not fit.
  return std::isfinite(sum) ? std::sqrt(sum / static_cast<double>(points.size())) : 1e9;
}

std::vector<double>
errorsOf(const std::vector<BoardPair>& pairs,
         const std::vector<cv::Point3f>& points,
         const CameraCalibration& neighbour,
         const Eigen::Isometry3d& T_neighbour_reference)
{
  std::vector<double> errors;
  for (const BoardPair& pair : pairs)
    errors.push_back(errorOf(pair, points, neighbour, T_neighbour_reference));
  return errors;
}

/** \brief The errors for the relative pose from that single shot which fits the others
 * best; shots that were mixed up do not affect it. */
std::vector<double>
errorsOfBestShot(const std::vector<BoardPair>& pairs,
                 const std::vector<cv::Point3f>& points,
                 const CameraCalibration& neighbour)
{
  std::vector<double> best;
  double minimum = std::numeric_limits<double>::max();
  for (const BoardPair& pair : pairs) {
    std::vector<double> errors =
        errorsOf(pairs, points, neighbour, pair.T_reference_neighbour().inverse());
    const double limit = outlierLimit(errors, 0.0);
    if (limit < minimum) {
      minimum = limit;
      best = std::move(errors);
    }
  }
  return best;
}

/** \brief Excludes the views whose error is above the limit. \return true if any were
 */
bool
leaveOutAbove(double limit,
              const std::vector<BoardPair>& pairs,
              const std::vector<double>& errors,
              std::vector<BoardView>& views,
              const LeaveOut& leave_out)
{
  std::vector<std::size_t> bad;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (errors[i] > limit) {
      bad.push_back(pairs[i].neighbour->image);
      leave_out(*pairs[i].neighbour,
                "does not fit the reference's image of this shot by " +
                    pixelText(errors[i]) +
                    " px: another shot's image, or a camera that moved");
    }
  const auto is_bad = [&](const BoardView& view) {
    return std::find(bad.begin(), bad.end(), view.image) != bad.end();
  };
  views.erase(std::remove_if(views.begin(), views.end(), is_bad), views.end());
  return !bad.empty();
}

/** \brief The pose fitted to all corners of all pairs. */
Eigen::Isometry3d
placeOf(const std::vector<BoardPair>& pairs,
        const std::vector<cv::Point3f>& points,
        const cv::Size& size,
        const CameraCalibration& reference,
        const CameraCalibration& neighbour)
{
  std::vector<std::vector<cv::Point2f>> corners_reference;
  std::vector<std::vector<cv::Point2f>> corners_neighbour;
  for (const BoardPair& pair : pairs) {
    corners_reference.push_back(pair.reference->corners);
    corners_neighbour.push_back(pair.neighbour->corners);
  }
  cv::Matx33d matrix_reference = matrixOf(reference);
  cv::Matx33d matrix_neighbour = matrixOf(neighbour);
  std::array<double, 5> distortion_reference = reference.distortion;
  std::array<double, 5> distortion_neighbour = neighbour.distortion;
  cv::Mat turn;
  cv::Mat shift;
  cv::Mat essential;
  cv::Mat fundamental;
  const std::vector<std::vector<cv::Point3f>> all_points(pairs.size(), points);
  cv::stereoCalibrate(all_points,
                      corners_reference,
                      corners_neighbour,
                      matrix_reference,
                      distortion_reference,
                      matrix_neighbour,
                      distortion_neighbour,
                      size,
                      turn,
                      shift,
                      essential,
                      fundamental,
                      cv::CALIB_FIX_INTRINSIC,
                      {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 100, 1e-9});
  return poseOf(turn, shift).inverse();
}

} // namespace

void
fitPlace(const CalibrationBoard& board,
         const cv::Size& size,
         const std::string& name,
         const CameraCalibration& reference,
         const std::vector<BoardView>& reference_views,
         CameraCalibration& neighbour,
         std::vector<BoardView>& views,
         const LeaveOut& leave_out)
{
  // The error of the board's pose in the reference exceeds the noise of a corner.
  constexpr double floor = 1.0; // px
  const std::vector<cv::Point3f> points = boardPoints(board);
  std::vector<BoardPair> pairs = pairsOf(reference_views, views);
  requireEnough(name, pairs.size());
  std::vector<double> errors = errorsOfBestShot(pairs, points, neighbour);
  while (leaveOutAbove(outlierLimit(errors, floor), pairs, errors, views, leave_out)) {
    pairs = pairsOf(reference_views, views);
    requireEnough(name, pairs.size());
    errors = errorsOfBestShot(pairs, points, neighbour);
  }
  neighbour.T_reference_camera = placeOf(pairs, points, size, reference, neighbour);
}

} // namespace pcl::acmap
